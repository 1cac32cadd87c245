// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace angiomesh {

/// A file that is open for reading at any place, by several threads. Closed with the object.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Else errno says why, and error().
  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
  /// The errno of a failed opening.
  [[nodiscard]] int error() const { return error_; }
  /// 0 when it cannot be told.
  [[nodiscard]] std::uintmax_t size() const;
  /// The number of bytes read: less than asked for at the end of the file, where errno is 0, and
  /// where reading fails, where it says why.
  std::size_t readAt(std::uintmax_t start, void* to, std::size_t bytes) const;

 private:
  int descriptor_;
  int error_ = 0;
};

/// That the system does not let a file or folder be opened or read, why, and what to do about it.
[[noreturn]] void throwNotOpened(const std::string& where, int error);

}  // namespace angiomesh

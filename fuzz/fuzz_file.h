// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "io/file/memory_file.h"

namespace angiomesh::fuzz {

/// The input as a file that lives in memory, for readers that take a path. Where its name matters,
/// a link with that ending leads to it.
class InputFile {
 public:
  InputFile(const std::uint8_t* data, std::size_t size, const std::string& ending) {
    if (!memory_.append({reinterpret_cast<const char*>(data), size}))
      throw std::runtime_error("no memory for the input");
    if (ending.empty()) return;
    link_ = std::filesystem::temp_directory_path() /
            ("angiomesh-fuzz-" + std::to_string(::getpid()) + ending);
    std::filesystem::remove(link_);
    std::filesystem::create_symlink(memory_.path(), link_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() {
    if (!link_.empty()) ::unlink(link_.c_str());
  }

  [[nodiscard]] std::filesystem::path path() const {
    return link_.empty() ? memory_.path() : link_;
  }

 private:
  MemoryFile memory_;
  std::filesystem::path link_;
};

/// A folder of this process that is empty in the beginning and gone in the end. Its name is the
/// same each time.
class InputFolder {
 public:
  InputFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("angiomesh-fuzz-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;
  ~InputFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  /// Writes a file, whose folder is made where it is missing.
  void add(const std::string& name, std::string_view bytes) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream out(path_ / name, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw std::runtime_error("no room for the input");
  }

 private:
  std::filesystem::path path_;
};

}  // namespace angiomesh::fuzz

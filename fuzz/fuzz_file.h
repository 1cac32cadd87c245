// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace angiomesh::fuzz {

/// The input as a file that lives in memory, for readers that take a path. Where its name matters,
/// a link with that ending leads to it.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size, const std::string& ending)
      : descriptor_(::memfd_create("input", 0)) {
    if (descriptor_ < 0 || ::write(descriptor_, data, size) != static_cast<ssize_t>(size))
      throw std::runtime_error("no memory for the input");
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
    if (ending.empty()) return;
    link_ = std::filesystem::temp_directory_path() /
            ("angiomesh-fuzz-" + std::to_string(::getpid()) + ending);
    std::filesystem::remove(link_);
    std::filesystem::create_symlink(path_, link_);
    path_ = link_;
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (!link_.empty()) ::unlink(link_.c_str());
    ::close(descriptor_);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  int descriptor_;
  std::filesystem::path path_, link_;
};

}  // namespace angiomesh::fuzz

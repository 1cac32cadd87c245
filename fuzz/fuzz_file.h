// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "io/memory_file.h"

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

}  // namespace angiomesh::fuzz

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace angiomesh {

/// A file that says that a program works somewhere: held by the system's lock on it (flock), which
/// ends with the program however that ends, whatever the file says and whoever left it. The file
/// goes with the object. No link is followed.
class FileLock {
 public:
  enum class State {
    Held,
    Taken,      ///< another program holds it
    Impossible  ///< the file cannot be made, or the file system knows no locks
  };

  explicit FileLock(std::filesystem::path file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  [[nodiscard]] State state() const { return state_; }

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  State state_ = State::Impossible;
};

/// Whether somebody holds the lock of a file or folder. Where there are no locks: nobody.
bool isLocked(const std::filesystem::path& path);

}  // namespace angiomesh

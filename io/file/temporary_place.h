// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace angiomesh {

/// A hidden file or folder in which something is made that is to appear as a whole. Its name tells
/// the machine and the process, and it is locked (flock) while the object lives, so that
/// removeLeftovers() knows what a program that was killed left behind.
class TemporaryPlace {
 public:
  enum class Kind { File, Folder };

  /// @param extension of a file, with its dot
  /// @throws std::filesystem::filesystem_error when it cannot be made
  TemporaryPlace(const std::filesystem::path& folder, Kind kind, const std::string& extension = "");
  /// Removes what still stands there.
  ~TemporaryPlace();
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Whether `path` has the name of a temporary place and the program that made it is gone: nobody
/// holds its lock, and its process is dead, or of another machine and a day old.
bool isLeftover(const std::filesystem::path& path);

/// The note in a temporary folder that all is made and moves into place, see StagedFolder.
inline constexpr const char* kCommitNote = "commit";

/// Removes the leftovers in a folder, but those with a kCommitNote.
void removeLeftovers(const std::filesystem::path& folder);

/// Forces a folder's entries to the medium, where the medium can.
void syncFolder(const std::filesystem::path& folder);

/// Renames onto nothing, or fails with std::errc::file_exists.
std::error_code renameNew(const std::filesystem::path& from, const std::filesystem::path& to);

/// The lock of an output folder, so that one program at a time writes to it: in the folder, or
/// beside one that is to be made. removeLeftovers() knows it.
std::filesystem::path outputLockFile(const std::filesystem::path& folder);

}  // namespace angiomesh

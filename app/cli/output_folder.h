// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace angiomesh::cli {

/// A folder of results that appears as a whole or not at all: files are written into a hidden
/// folder on the same file system and renamed into place by commit(). Files of the user that lie in
/// an existing folder are left alone. Unless committed, the destructor removes everything again.
class OutputFolder {
 public:
  /// @param folder made when it does not exist   @param names the files that a run may write: those
  /// of a former run are replaced   @param replace whether a former run may be replaced
  /// @throws InputError when `folder` holds one of `names` and `replace` is false
  /// @throws IoError when the folder cannot be made or written to
  OutputFolder(const std::filesystem::path& folder, std::vector<std::string> names, bool replace);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Calls `write` with the place where the file `name` waits for commit().
  /// @throws IoError of `write`, with the place where the file was to be in the end
  void add(const std::string& name,
           const std::function<void(const std::filesystem::path& place)>& write) const;

  /// Puts the written files in place of those of a former run. @throws IoError, with the former run
  /// as it was
  void commit();

 private:
  void makeStage(const std::filesystem::path& stage);
  void moveIntoExisting();

  std::filesystem::path folder_, stage_;
  std::filesystem::path firstMade_;  ///< the outermost folder that was made for this output
  std::vector<std::string> names_;
  bool existed_ = false;
  bool committed_ = false;
};

/// Finds out early, before a long computation, that a file cannot be written.
/// @throws IoError when its folder does not exist or may not be written to
void checkOutputFile(const std::filesystem::path& file);

}  // namespace angiomesh::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/file/file_lock.h"
#include "io/file/temporary_place.h"

namespace angiomesh {

/// A place inside a folder that may be a stranger's: `name` is a path from it without "..", and no
/// link stands on the way or in the end, so that nothing outside is read or written.
/// @throws IoError that names what is in the way
std::filesystem::path placeIn(const std::filesystem::path& folder, const std::string& name);

/// Goes on with what programs that were killed within StagedFolder::commit() had begun in a folder.
/// @throws IoError where that cannot be done
void finishCommits(const std::filesystem::path& folder);

/// A folder of results that appears as a whole or not at all: files are written into a hidden
/// folder on the same file system and renamed into place by commit(). Files of the user that lie in
/// an existing folder are left alone. Unless committed, the destructor removes everything again. A
/// program that is killed in between leaves hidden files that the next StagedFolder there removes;
/// killed within commit(), it leaves what the next one finishes.
class StagedFolder {
 public:
  /// Whether the folder is this result's, or one where several programs may write files of their
  /// own at a time.
  enum class Writers { One, Many };

  /// @param folder made when it does not exist   @param names the files that may be written: those
  /// of a former run are replaced   @param replace whether a former run may be replaced
  /// @throws InputError when `folder` holds one of `names` and `replace` is false, or when another
  /// program is writing to it
  /// @throws IoError when the folder cannot be made or written to, or a link stands in it in place
  /// of one of `names`
  StagedFolder(const std::filesystem::path& folder, std::vector<std::string> names, bool replace,
               Writers writers = Writers::One);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Calls `write` with the place where the file `name` waits for commit().
  /// @throws IoError of `write`, with the place where the file was to be in the end
  void add(const std::string& name,
           const std::function<void(const std::filesystem::path& place)>& write) const;

  /// Puts the written files in place of those of a former run.
  /// @throws IoError, InputError (another program made the folder meanwhile), with the former run
  /// as it was
  void commit();

 private:
  void makeParent(const std::filesystem::path& folder);
  void appear();
  void moveIntoExisting();

  std::filesystem::path folder_;
  std::filesystem::path firstMade_;  ///< the outermost folder that was made for this output
  std::vector<std::string> names_;
  std::optional<FileLock> lock_;
  std::optional<TemporaryPlace> stage_;
  bool existed_ = false, replace_ = false, committed_ = false;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/staged_folder.h"

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "io/file/files.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const char* const kElsewhere = "choose another place with -o";
const char* const kFormer = "former";

[[noreturn]] void failToWrite(const std::string& what, const fs::path& where,
                              const std::error_code& error) {
  throw IoError(what + " (" + error.message() + ")", where.string(), kElsewhere);
}

[[noreturn]] void refuseTaken(const fs::path& folder, const std::string& name) {
  throw InputError("the output folder already holds a result (" + name + ")", folder.string(),
                   "choose another folder with -o, or replace it with --force");
}

fs::path withoutTrailingSlash(const fs::path& path) {
  std::error_code error;
  fs::path whole = fs::absolute(path, error).lexically_normal();
  if (error) failToWrite("cannot resolve the output folder", path, error);
  return whole.has_filename() ? whole : whole.parent_path();
}

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/// The renames of a commit, which are undone in reverse order unless all were made.
class Moves {
 public:
  Moves(fs::path stage, fs::path folder) : stage_(std::move(stage)), folder_(std::move(folder)) {}

  /// Out of the way, with the old file in its place as long as that is possible.
  std::error_code setAside(const std::string& name) {
    std::error_code error;
    const fs::path former = stage_ / kFormer / name;
    fs::create_directories(former.parent_path(), error);
    if (error) return error;
    fs::create_hard_link(folder_ / name, former, error);
    if (error) fs::rename(folder_ / name, former, error);
    if (!error) former_.push_back(name);
    return error;
  }

  std::error_code bring(const std::string& name, bool replace) {
    std::error_code error;
    const fs::path to = folder_ / name;
    fs::create_directories(to.parent_path(), error);
    if (error) return error;
    if (replace)
      fs::rename(stage_ / name, to, error);
    else
      error = renameNew(stage_ / name, to);
    if (!error) brought_.push_back(name);
    return error;
  }

  void undo() {
    std::error_code ignored;
    for (auto name = brought_.rbegin(); name != brought_.rend(); ++name)
      fs::rename(folder_ / *name, stage_ / *name, ignored);
    for (auto name = former_.rbegin(); name != former_.rend(); ++name)
      fs::rename(stage_ / kFormer / *name, folder_ / *name, ignored);
  }

 private:
  fs::path stage_, folder_;
  std::vector<std::string> former_, brought_;
};

/// Goes on with what a program that was killed within commit() had begun.
void finish(const fs::path& stage, const fs::path& folder) {
  std::error_code error;
  const Json note = parseJson<Json>(readText(placeIn(stage, kCommitNote), kMostJsonBytes));
  if (note.is_object() && note.contains("names") && note.contains("gone")) {
    for (const Json& name : note["names"]) {
      const fs::path from = placeIn(stage, name.get<std::string>());
      const fs::path to = placeIn(folder, name.get<std::string>());
      if (!fs::is_regular_file(from, error)) continue;
      fs::create_directories(to.parent_path(), error);
      // Another program may be at the same.
      fs::rename(from, to, error);
      if (error && isThere(from)) throw fs::filesystem_error("", from, error);
    }
    for (const Json& name : note["gone"]) {
      const fs::path old = placeIn(folder, name.get<std::string>());
      if (fs::is_regular_file(old, error)) fs::remove(old);
    }
    syncFolder(folder);
  }
  fs::remove_all(stage, error);
}

}  // namespace

fs::path placeIn(const fs::path& folder, const std::string& name) {
  fs::path place = folder;
  for (const fs::path& part : fs::path(name)) {
    if (part == ".." || part.is_absolute())
      throw IoError("a name leads out of the folder (" + name + ")", folder.string(),
                    "give a folder that Angiomesh wrote");
    place /= part;
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(place, error)))
      throw IoError("a link stands in place of a file, and links are not followed here",
                    place.string(), "put a copy of what it leads to in its place, or remove it");
  }
  return place;
}

void finishCommits(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> stages;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (isLeftover(entry->path()) && isThere(entry->path() / kCommitNote))
      stages.push_back(entry->path());
  for (const fs::path& stage : stages) {
    try {
      finish(stage, folder);
    } catch (const std::exception&) {
      if (!isThere(stage)) continue;
      throw IoError("a run that was interrupted left a result that cannot be finished",
                    stage.string(), "remove that folder");
    }
  }
}

StagedFolder::StagedFolder(const fs::path& folder, std::vector<std::string> names, bool replace,
                           Writers writers)
    : folder_(withoutTrailingSlash(folder)), names_(std::move(names)), replace_(replace) {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  existed_ = fs::exists(status);
  if (existed_ && !fs::is_directory(status))
    throw IoError("the output place is not a folder", folder.string(), kElsewhere);
  if (!existed_) makeParent(folder);
  if (writers == Writers::One) lock_.emplace(outputLockFile(folder_));
  if (lock_ && lock_->state() == FileLock::State::Taken)
    throw InputError("another run is writing to this place", folder.string(),
                     "wait until it has ended, or choose another place with -o");
  const fs::path near = existed_ ? folder_ : folder_.parent_path();
  removeLeftovers(near);
  if (existed_) {
    finishCommits(folder_);
    for (const std::string& name : names_)
      if (isThere(placeIn(folder_, name)) && !replace) refuseTaken(folder, name);
  }
  try {
    stage_.emplace(near, TemporaryPlace::Kind::Folder);
  } catch (const fs::filesystem_error& failure) {
    failToWrite("cannot write to the output folder", folder_, failure.code());
  }
}

void StagedFolder::makeParent(const fs::path& folder) {
  std::error_code error;
  const fs::path parent = folder_.parent_path();
  for (fs::path up = parent; !up.empty() && !fs::exists(up, error); up = up.parent_path())
    firstMade_ = up;
  fs::create_directories(parent, error);
  if (error) failToWrite("cannot make the output folder", folder, error);
}

StagedFolder::~StagedFolder() {
  stage_.reset();
  lock_.reset();
  if (committed_ || firstMade_.empty()) return;
  // Only folders that are empty go; somebody may have put files there meanwhile.
  std::error_code error;
  for (fs::path up = folder_.parent_path(); fs::remove(up, error) && up != firstMade_;)
    up = up.parent_path();
}

void StagedFolder::add(const std::string& name,
                       const std::function<void(const fs::path&)>& write) const {
  const fs::path place = stage_->path() / name;
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  try {
    write(place);
  } catch (const IoError& failure) {
    std::string line = failure.what();
    const std::string waiting = stage_->path().string();
    const std::size_t at = line.find(waiting);
    if (at != std::string::npos) line.replace(at, waiting.size(), folder_.string());
    throw IoError(line, "", "");
  }
}

void StagedFolder::commit() {
  if (existed_)
    moveIntoExisting();
  else
    appear();
  committed_ = true;
}

void StagedFolder::appear() {
  const std::error_code error = renameNew(stage_->path(), folder_);
  if (error == std::errc::file_exists)
    throw InputError("the output folder was made by somebody else meanwhile", folder_.string(),
                     kElsewhere);
  if (error) failToWrite("cannot put the result into the output folder", folder_, error);
  syncFolder(folder_.parent_path());
}

void StagedFolder::moveIntoExisting() {
  const fs::path& stage = stage_->path();
  std::vector<std::string> fresh, gone;
  for (const std::string& name : names_) {
    const bool there = isThere(placeIn(folder_, name));
    if (there && !replace_) refuseTaken(folder_, name);
    if (isThere(stage / name))
      fresh.push_back(name);
    else if (there && replace_)
      gone.push_back(name);
  }
  // Names need not be UTF-8; those that are not are not finished.
  if (replace_)
    writeText(stage / kCommitNote, Json{{"names", fresh}, {"gone", gone}}.dump(
                                       -1, ' ', false, Json::error_handler_t::replace));
  Moves moves(stage, folder_);
  std::error_code error;
  for (std::size_t n = 0; n < fresh.size() && !error; ++n) {
    if (replace_ && isThere(folder_ / fresh[n])) error = moves.setAside(fresh[n]);
    if (!error) error = moves.bring(fresh[n], replace_);
  }
  for (std::size_t n = 0; n < gone.size() && !error; ++n) {
    error = moves.setAside(gone[n]);
    if (!error) fs::remove(folder_ / gone[n], error);
  }
  if (!error) {
    syncFolder(folder_);
    return;
  }
  moves.undo();
  std::error_code ignored;
  fs::remove(stage / kCommitNote, ignored);
  if (error == std::errc::file_exists) refuseTaken(folder_, "made by somebody else meanwhile");
  failToWrite("cannot replace the result in the output folder", folder_, error);
}

}  // namespace angiomesh

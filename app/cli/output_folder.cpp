// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/output_folder.h"

#include <unistd.h>

#include <system_error>
#include <utility>

#include "core/base/error.h"

namespace angiomesh::cli {
namespace fs = std::filesystem;
namespace {

std::string elsewhere() { return "choose another place with -o"; }

[[noreturn]] void failToWrite(const std::string& what, const fs::path& where,
                              const std::error_code& error) {
  throw IoError(what + " (" + error.message() + ")", where.string(), elsewhere());
}

fs::path withoutTrailingSlash(const fs::path& path) {
  std::error_code error;
  fs::path whole = fs::absolute(path, error).lexically_normal();
  if (error) failToWrite("cannot resolve the output folder", path, error);
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder, std::vector<std::string> names, bool replace)
    : folder_(withoutTrailingSlash(folder)), names_(std::move(names)) {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  existed_ = fs::exists(status);
  if (existed_ && !fs::is_directory(status))
    throw IoError("the output place is not a folder", folder.string(), elsewhere());

  const std::string tag = ".angiomesh-part-" + std::to_string(getpid());
  if (existed_) {
    for (const std::string& name : names_)
      if (!replace && fs::exists(folder_ / name, error))
        throw InputError("the output folder already holds a result (" + name + ")", folder.string(),
                         "choose another folder with -o, or replace it with --force");
    makeStage(folder_ / tag);
    return;
  }
  const fs::path parent = folder_.parent_path();
  for (fs::path up = parent; !up.empty() && !fs::exists(up, error); up = up.parent_path())
    firstMade_ = up;
  fs::create_directories(parent, error);
  if (error) failToWrite("cannot make the output folder", folder, error);
  makeStage(parent / ("." + folder_.filename().string() + tag));
}

void OutputFolder::makeStage(const fs::path& stage) {
  std::error_code error;
  fs::remove_all(stage, error);
  fs::create_directory(stage, error);
  if (error) failToWrite("cannot write to the output folder", folder_, error);
  stage_ = stage;
}

OutputFolder::~OutputFolder() {
  std::error_code error;
  if (!stage_.empty()) fs::remove_all(stage_, error);
  if (committed_ || firstMade_.empty()) return;
  // Only folders that are empty go; somebody may have put files there meanwhile.
  for (fs::path up = folder_.parent_path(); fs::remove(up, error) && up != firstMade_;)
    up = up.parent_path();
}

void OutputFolder::add(const std::string& name,
                       const std::function<void(const fs::path&)>& write) const {
  try {
    write(stage_ / name);
  } catch (const IoError& error) {
    std::string line = error.what();
    const std::string waiting = stage_.string();
    const std::size_t at = line.find(waiting);
    if (at != std::string::npos) line.replace(at, waiting.size(), folder_.string());
    throw IoError(line, "", "");
  }
}

void OutputFolder::commit() {
  if (existed_) {
    moveIntoExisting();
  } else {
    std::error_code error;
    fs::rename(stage_, folder_, error);
    if (error) failToWrite("cannot put the result into the output folder", folder_, error);
    stage_.clear();
  }
  committed_ = true;
}

void OutputFolder::moveIntoExisting() {
  const fs::path former = stage_ / "former";
  std::error_code error;
  fs::create_directory(former, error);
  if (error) failToWrite("cannot write to the output folder", folder_, error);

  std::vector<std::pair<fs::path, fs::path>> moves;  // from, to: undone in reverse order
  const auto move = [&](const fs::path& from, const fs::path& to) {
    fs::rename(from, to, error);
    if (!error) {
      moves.emplace_back(from, to);
      return;
    }
    std::error_code ignored;
    for (auto undo = moves.rbegin(); undo != moves.rend(); ++undo)
      fs::rename(undo->second, undo->first, ignored);
    failToWrite("cannot replace the result in the output folder", folder_, error);
  };
  std::error_code ignored;
  for (const std::string& name : names_)
    if (fs::exists(folder_ / name, ignored)) move(folder_ / name, former / name);
  for (const std::string& name : names_)
    if (fs::exists(stage_ / name, ignored)) move(stage_ / name, folder_ / name);
}

void checkOutputFile(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw IoError("there is no such folder", folder.string(), "make it first, or " + elsewhere());
  if (access(folder.c_str(), W_OK) != 0)
    throw IoError("the folder may not be written to", folder.string(), elsewhere());
}

}  // namespace angiomesh::cli

// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "io/file/staged_folder.h"
#include "io/file/temporary_place.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

const char* const kAdvice = "check that the folder may be written to and has free space";

std::string reason(int code) { return std::generic_category().message(code); }

std::string extensionOf(const fs::path& target) {
  return target.filename().string().ends_with(".nii.gz") ? ".nii.gz" : target.extension().string();
}

/// Once in a process for each folder.
void removeLeftoversOnce(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> done;
  {
    const std::lock_guard lock(mutex);
    if (!done.insert(folder).second) return;
  }
  removeLeftovers(folder);
}

/// A medium that is full or fails may report it only when the data are forced out.
void flushToMedium(const fs::path& file, const fs::path& target) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool bad = descriptor < 0 || (::fsync(descriptor) != 0 && errno != EINVAL);
  const int code = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (bad) throw IoError("cannot write the file (" + reason(code) + ")", target.string(), kAdvice);
}

}  // namespace

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void checkTarget(const fs::path& target) {
  std::error_code error;
  const fs::path folder = folderOf(target);
  if (!target.has_filename())
    throw IoError("no file name is given", target.string(), "add a file name to the folder");
  if (!fs::exists(folder, error))
    throw IoError("cannot write the file, there is no such folder", target.string(),
                  "make the folder first or choose another place");
  if (!fs::is_directory(folder, error))
    throw IoError("cannot write the file, its folder is a file", target.string(),
                  "choose another place");
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
    throw IoError("cannot write the file, a folder has this name", target.string(),
                  "choose another name");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw IoError("cannot write the file, the name belongs to a device", target.string(),
                  "choose another name");
}

void writeAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::error_code error;
  // A symbolic link stays a link: what it points to is replaced.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path) : path;
  checkTarget(target);
  const fs::path folder = folderOf(target);
  removeLeftoversOnce(folder);
  // Finished later, they would replace this file by an older one.
  finishCommits(folder);
  std::optional<TemporaryPlace> temporary;
  try {
    temporary.emplace(folder, TemporaryPlace::Kind::File, extensionOf(target));
  } catch (const fs::filesystem_error& failure) {
    throw IoError("cannot write the file (" + failure.code().message() + ")", path.string(),
                  kAdvice);
  }
  write(temporary->path());
  flushToMedium(temporary->path(), path);
  fs::rename(temporary->path(), target, error);
  if (error)
    throw IoError("cannot write the file (" + error.message() + ")", path.string(),
                  "choose another place");
  syncFolder(folder);
}

void writeText(const fs::path& path, std::string_view text) {
  writeAtomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out)
      throw IoError("cannot write the file (" + reason(errno) + ")", path.string(), kAdvice);
  });
}

std::string readText(const fs::path& path, std::uintmax_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
    throw IoError("cannot read the file, it is a folder", path.string(), "give a file");
  // A pipe or a device may never end.
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw IoError("cannot read the file, it is a pipe or a device", path.string(),
                  "copy what it holds to a file first");
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw IoError("cannot read the file (" + reason(errno) + ")", path.string(),
                  "check the name and the permissions");
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > most)
    throw IoError(
        "the file is larger than such a file can be (" + std::to_string(size >> 20) + " MB)",
        path.string(), "check the name");
  std::string text(error ? 0 : size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad())
    throw IoError("cannot read the file (" + reason(errno) + ")", path.string(),
                  "check the medium");
  return text;
}

}  // namespace angiomesh

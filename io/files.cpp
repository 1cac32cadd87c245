// SPDX-License-Identifier: BSD-3-Clause
#include "io/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>

#include "core/base/error.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

const char* const kAdvice = "check that the folder may be written to and has free space";

std::string reason(int code) { return std::generic_category().message(code); }

fs::path temporaryBeside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  static const unsigned salt = std::random_device{}();
  const std::string extension =
      target.filename().string().ends_with(".nii.gz") ? ".nii.gz" : target.extension().string();
  // Process and salt: two programs, perhaps on two machines, may write to one shared folder.
  return target.parent_path() /
         (".angiomesh-" + std::to_string(::getpid()) + "-" + std::to_string(salt) + "-" +
          std::to_string(counter++) + extension);
}

/// Throws unless a regular file can come to stand at `target`.
void checkTarget(const fs::path& target) {
  std::error_code error;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
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

/// A medium that is full or fails may report it only when the data are forced out.
void flushToMedium(const fs::path& file, const fs::path& target) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool bad = descriptor < 0 || (::fsync(descriptor) != 0 && errno != EINVAL);
  const int code = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (bad) throw IoError("cannot write the file (" + reason(code) + ")", target.string(), kAdvice);
}

}  // namespace

void writeAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::error_code error;
  // A symbolic link stays a link: what it points to is replaced.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path) : path;
  checkTarget(target);
  const fs::path temporary = temporaryBeside(target);
  {
    std::ofstream probe(temporary, std::ios::binary);
    if (!probe)
      throw IoError("cannot write the file (" + reason(errno) + ")", path.string(), kAdvice);
  }
  try {
    write(temporary);
    flushToMedium(temporary, path);
    fs::rename(temporary, target, error);
    if (error)
      throw IoError("cannot write the file (" + error.message() + ")", path.string(),
                    "choose another place");
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
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

std::string readText(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw IoError("cannot read the file, it is a folder", path.string(), "give a file");
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw IoError("cannot read the file (" + reason(errno) + ")", path.string(),
                  "check the name and the permissions");
  const std::uintmax_t size = fs::file_size(path, error);
  std::string text(error ? 0 : size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  // Of a file that has grown meanwhile, or whose size nobody knows beforehand.
  if (in) text.append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  if (in.bad())
    throw IoError("cannot read the file (" + reason(errno) + ")", path.string(),
                  "check the medium");
  return text;
}

}  // namespace angiomesh

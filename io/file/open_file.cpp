// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/open_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"

namespace angiomesh {

OpenFile::OpenFile(const std::filesystem::path& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) error_ = errno;
}

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::uintmax_t OpenFile::size() const {
  struct stat state {};
  return ::fstat(descriptor_, &state) == 0 ? static_cast<std::uintmax_t>(state.st_size) : 0;
}

std::size_t OpenFile::readAt(std::uintmax_t start, void* to, std::size_t bytes) const {
  std::size_t got = 0;
  while (got < bytes) {
    const ssize_t n = ::pread(descriptor_, static_cast<std::byte*>(to) + got, bytes - got,
                              static_cast<off_t>(start + got));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return got;
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  errno = 0;
  return got;
}

void throwNotOpened(const std::string& where, int error) {
  const char* advice = "check the medium";
  if (error == EMFILE || error == ENFILE)
    advice = "raise the limit on open files (ulimit -n), or close other programs";
  else if (error == EACCES || error == EPERM)
    advice = "check the permissions";
  else if (error == ENOENT || error == ENOTDIR)
    advice = "check the name";
  throw IoError("it cannot be opened or read (" + std::generic_category().message(error) + ")",
                where, advice);
}

}  // namespace angiomesh

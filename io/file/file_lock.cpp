// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace angiomesh {
namespace {

bool isSame(int descriptor, const std::filesystem::path& path) {
  struct stat mine {};
  struct stat there {};
  return ::fstat(descriptor, &mine) == 0 && ::lstat(path.c_str(), &there) == 0 &&
         mine.st_ino == there.st_ino && mine.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(std::filesystem::path file) : file_(std::move(file)) {
  for (;;) {
    descriptor_ =
        ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600);
    if (descriptor_ < 0) return;
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) break;
    if (isSame(descriptor_, file_)) {
      state_ = State::Held;
      return;
    }
    // Whoever held it before removed the file after it was opened here.
    ::close(descriptor_);
  }
  if (errno == EWOULDBLOCK)
    state_ = State::Taken;
  else
    ::unlink(file_.c_str());
  ::close(descriptor_);
}

FileLock::~FileLock() {
  if (state_ != State::Held) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

bool isLocked(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return held;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/quiet_terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace angiomesh {
namespace {

std::recursive_mutex& only() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace

QuietTerminal::QuietTerminal() : lock_(only()) {
  std::fflush(stderr);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  stderr_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  if (stderr_ >= 0) ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

QuietTerminal::~QuietTerminal() {
  if (stderr_ < 0) return;
  std::fflush(stderr);
  ::dup2(stderr_, STDERR_FILENO);
  ::close(stderr_);
}

}  // namespace angiomesh

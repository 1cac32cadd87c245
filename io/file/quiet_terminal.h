// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace angiomesh {

/// Keeps the terminal free of what the MetaImage, NIfTI and VTK libraries print there by
/// themselves, on top of the status that they return. One at a time: some of them are not made for
/// threads. What other threads write to stderr meanwhile is lost, so keep it short.
class QuietTerminal {
 public:
  QuietTerminal();
  ~QuietTerminal();
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  int stderr_ = -1;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace angiomesh {

using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace angiomesh

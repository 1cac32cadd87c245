// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "core/base/parallel.h"

namespace angiomesh {

/// What `make` returns on one thread and then on `several`; their number stays set.
template <class Make>
auto onOneAndSeveralThreads(Make make, int several = 2) {
  setThreads(1);
  auto one = make();
  setThreads(several);
  return std::pair(std::move(one), make());
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/progress.h"

namespace angiomesh {

/// Sets the number of threads used by core, by ITK and by VTK's filters; 0 means all cores.
/// Call it once, in app/, before the first computation.
void setThreads(int count);

/// The number of threads in use.
int threads();

/// Calls body(first, last) for consecutive blocks of [begin, end) of at most `grain` items, in
/// parallel and in no particular order. Blocks start at begin + n * grain for any number of
/// threads, so that per-block partial results summed in block order do not depend on it. An
/// exception thrown by `body` (Cancelled among them) is rethrown here.
void parallelFor(std::size_t begin, std::size_t end, std::size_t grain,
                 const std::function<void(std::size_t first, std::size_t last)>& body);

/// Calls each(n) for the items of [0, count), as parallelFor() does for blocks.
template <class Each>
void parallelForEach(std::size_t count, std::size_t grain, const Each& each) {
  parallelFor(0, count, grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) each(n);
  });
}

/// The same, with a check of `progress` before each block.
template <class Each>
void parallelForEach(std::size_t count, std::size_t grain, const Progress& progress,
                     const Each& each) {
  parallelFor(0, count, grain, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t n = first; n < last; ++n) each(n);
  });
}

}  // namespace angiomesh

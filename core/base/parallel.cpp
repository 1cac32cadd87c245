// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/parallel.h"

#include <itkMultiThreaderBase.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

namespace angiomesh {
namespace {

// VTK's filters run on TBB as well (its SMP back end), so this limit reaches them too.
std::unique_ptr<tbb::global_control> limit;

}  // namespace

void setThreads(int count) {
  const int all = tbb::info::default_concurrency();
  const int n = count > 0 ? count : all;
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(n));
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(static_cast<itk::ThreadIdType>(n));
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(static_cast<itk::ThreadIdType>(n));
}

int threads() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallelFor(std::size_t begin, std::size_t end, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& body) {
  if (end <= begin) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t blocks = (end - begin + grain - 1) / grain;
  const auto block = [&](std::size_t b) {
    const std::size_t first = begin + b * grain;
    body(first, std::min(end, first + grain));
  };
  if (blocks == 1 || threads() == 1) {
    for (std::size_t b = 0; b < blocks; ++b) block(b);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, blocks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t b = range.begin(); b != range.end(); ++b) block(b);
      },
      tbb::simple_partitioner());
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/parallel.h"

#include <itkMultiThreaderBase.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

#include <algorithm>
#include <memory>

namespace angiomesh {
namespace {

// VTK's filters run on TBB as well (its SMP back end), so this limit reaches them too.
std::unique_ptr<tbb::global_control> limit;

/// The order that TBB gives a parallel loop: what was done before it is seen by every block, and
/// what the blocks did is seen after it. ThreadSanitizer has to be told, because Debian's TBB is
/// built without it.
struct LoopOrder {
#if defined(__SANITIZE_THREAD__)
  char start = 0;
  char end = 0;
  void publish() { __tsan_release(&start); }
  void enterBlock() { __tsan_acquire(&start); }
  void leaveBlock() { __tsan_release(&end); }
  void collect() { __tsan_acquire(&end); }
#else
  void publish() {}
  void enterBlock() {}
  void leaveBlock() {}
  void collect() {}
#endif
};

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
  LoopOrder order;
  struct Block {
    LoopOrder& order;
    explicit Block(LoopOrder& o) : order(o) { order.enterBlock(); }
    ~Block() { order.leaveBlock(); }
  };
  struct Loop {
    LoopOrder& order;
    explicit Loop(LoopOrder& o) : order(o) { order.publish(); }
    ~Loop() { order.collect(); }
  };
  const Loop loop(order);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, blocks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        const Block inside(order);
        for (std::size_t b = range.begin(); b != range.end(); ++b) block(b);
      },
      tbb::simple_partitioner());
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/preview_job.h"

#include <exception>

#include "core/base/clock.h"
#include "core/base/error.h"

namespace angiomesh {

namespace {

/// Between two pictures of the front, s.
constexpr double kBetweenFronts = 0.2;

}  // namespace

void PreviewJob::execute() noexcept {
  const Clock::time_point start = Clock::now();
  try {
    RunOptions options;
    options.snapshots = snapshots;
    options.snapshotSeconds = kBetweenFronts;
    options.frontsAlone = true;
    phi = previewInBox(ground, box, params, options, progress).phi;
  } catch (const Cancelled&) {
    phi.reset();
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  seconds = secondsSince(start);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/sensitivity_job.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/statistics.h"

namespace angiomesh {

namespace {

/// Part of the way that is the run without any step.
constexpr double kFirstShare = 0.1;
constexpr double kScalePercentile = 0.98, kLeastScaleMm = 0.01;

DrawnSensitivity drawnOf(Sensitivity found) {
  DrawnSensitivity drawn;
  drawn.found = std::move(found);
  const Sensitivity& s = drawn.found;
  drawn.wall = std::make_shared<const TriMesh>(s.places.wall);
  const auto& triangles = drawn.wall->triangles;
  drawn.spread.reserve(triangles.size());
  for (const auto& t : triangles)
    drawn.spread.push_back(std::max({s.spreadMm[t[0]], s.spreadMm[t[1]], s.spreadMm[t[2]]}));
  for (const StepEffect& effect : s.effects) {
    std::vector<float>& moves = drawn.moves.emplace_back();
    if (!effect.why.empty()) continue;
    const std::vector<float>& at = effect.moves.movedMm;
    moves.reserve(triangles.size());
    for (const auto& t : triangles) moves.push_back((at[t[0]] + at[t[1]] + at[t[2]]) / 3.0F);
  }
  std::vector<float> spread = s.spreadMm;
  drawn.scaleMm = spread.empty() ? kLeastScaleMm
                                 : std::max(kLeastScaleMm, percentile(spread, kScalePercentile));
  return drawn;
}

}  // namespace

void SensitivityJob::execute() noexcept {
  const Clock::time_point start = Clock::now();
  try {
    Pipeline pipeline(source);
    RunOptions options;
    options.until = Step::Correct;
    const RunResult base = pipeline.run(params, options, progress.sub(0.0, kFirstShare));
    const std::vector<ParameterStep> steps = parameterSteps(params, contextOf(base));
    drawn = std::make_shared<const DrawnSensitivity>(
        drawnOf(sensitivityOf(pipeline, params, steps, progress.sub(kFirstShare, 1.0))));
  } catch (const Cancelled&) {
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  seconds = secondsSince(start);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/run_job.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/error.h"

namespace angiomesh {

namespace {

constexpr int kFirst = static_cast<int>(Step::Preprocess);

/// The window promises two pictures of the evolving surface per second.
constexpr double kSnapshotSeconds = 0.3;

/// Where each step begins on the pipeline's own scale of progress; off values would only make a
/// progress bar uneven.
constexpr std::array<double, kStepCount + 1> kShares{0.0,  0.0,  0.05, 0.35, 0.35,
                                                     0.80, 0.88, 0.94, 1.0};

std::shared_ptr<const MeshFacts> measureFacts(const RunResult& run) {
  auto facts = std::make_shared<MeshFacts>();
  const std::array<const TriMesh*, kMeshKindCount> meshes{
      run.smoothed.get(), run.surface->mesh.get(), run.surface->marchingCubes.get()};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i]) {
      facts->minAnglesDeg[i] = minAngles(*meshes[i]);
      facts->radiusRatios[i] = radiusRatios(*meshes[i]);
    }
  }
  return facts;
}

}  // namespace

RunJob::RunJob(std::shared_ptr<Pipeline> pipeline, const Parameters& params, Step until)
    : pipeline_(std::move(pipeline)), params_(params), until_(until), lastWanted_(until) {}

void RunJob::execute() noexcept {
  try {
    runSteps();
  } catch (const Cancelled&) {
    end_ = End::Cancelled;
  } catch (const std::bad_alloc&) {
    end_ = End::Failed;
    error_ = std::string("not enough memory, ") + stepId(step()) +
             ": draw a smaller region of interest or turn resampling off";
  } catch (const std::exception& failure) {
    end_ = End::Failed;
    error_ = failure.what();
  }
}

void RunJob::runSteps() {
  // Up to the evolution each call computes one step and finds those before it in the pipeline's
  // cache: so every result can be shown as soon as it is there. From then on it is one call, since
  // an evolution that was ended by hand is in no cache.
  int next = kFirst;
  while (next <= static_cast<int>(until_)) {
    if (next > static_cast<int>(lastWanted_.load())) {
      end_ = End::Stopped;
      return;
    }
    const Step first = static_cast<Step>(next);
    if (skips(first)) {
      ++next;
      continue;
    }
    RunOptions options;
    options.until = first < Step::Evolve ? first : until_;
    options.snapshots = snapshots_;
    options.snapshotSeconds = kSnapshotSeconds;
    options.control = control_;
    options.keepOnFailure = true;
    options.warned = [this](Step step, const std::string& warning) {
      const std::lock_guard lock(mutex_);
      warnings_.emplace_back(step, warning);
    };
    const Progress progress = begin(first);
    RunResult run = pipeline_->run(params_, options, progress);
    const std::optional<RunFailure> failure = run.failure;
    collect(first, std::move(run));
    if (failure) {
      end_ = End::Failed;
      error_ = failure->why;
      return;
    }
    next = static_cast<int>(options.until) + 1;
  }
}

bool RunJob::skips(Step step) const {
  if (step != Step::Vesselness && step != Step::Seeds) {
    return false;
  }
  return isSegmented(params_) || (until_ >= Step::Evolve && pipeline_->has(Step::Evolve, params_) &&
                                  !pipeline_->has(step, params_));
}

Progress RunJob::begin(Step step) {
  const std::lock_guard lock(mutex_);
  progress_ = Progress();
  if (cancelled_) {
    progress_.cancel();
  }
  first_ = step;
  return progress_;
}

void RunJob::collect(Step first, RunResult run) {
  seconds_ += run.totalSeconds;
  cpuSeconds_ += run.cpuSeconds;
  run.totalSeconds = seconds_;
  run.cpuSeconds = cpuSeconds_;
  // What an earlier part computed is "reused" by the later ones, but not by the run as a whole.
  for (std::size_t i = 0; i < run.stages.size() && i < stages_.size(); ++i) {
    run.stages[i] = stages_[i];
  }
  stages_ = run.stages;
  const auto shared = std::make_shared<const RunResult>(std::move(run));
  for (const StageReport& stage : shared->stages) {
    if (stage.step < first) {
      continue;
    }
    StepResult result;
    result.step = stage.step;
    result.key = stage.key;
    result.run = shared;
    if (stage.step == Step::Quality) {
      result.facts = measureFacts(*shared);
    }
    const std::lock_guard lock(mutex_);
    results_.push_back(std::move(result));
  }
}

Step RunJob::step() const {
  const Step first = first_;
  if (first < Step::Evolve) {
    return first;
  }
  const char* phase = progress().phase();
  return std::max(first, phase ? stepFromId(phase).value_or(first) : first);
}

Progress RunJob::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

double RunJob::fraction() const {
  const auto next = static_cast<std::size_t>(step()) + 1;
  return std::min(progress().fraction(), kShares[next]);
}

double RunJob::stepFraction() const {
  const auto i = static_cast<std::size_t>(step());
  const double width = kShares[i + 1] - kShares[i];
  return width <= 0.0 ? 1.0 : std::clamp((progress().fraction() - kShares[i]) / width, 0.0, 1.0);
}

void RunJob::cancel() {
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  progress_.cancel();
}

void RunJob::stopAfterStep() { lastWanted_ = std::min(lastWanted_.load(), step()); }

std::vector<std::pair<Step, std::string>> RunJob::takeWarnings() {
  const std::lock_guard lock(mutex_);
  return std::exchange(warnings_, {});
}

std::vector<StepResult> RunJob::takeResults() {
  const std::lock_guard lock(mutex_);
  return std::exchange(results_, {});
}

}  // namespace angiomesh

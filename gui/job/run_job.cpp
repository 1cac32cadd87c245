// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/run_job.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "core/base/error.h"

namespace angiomesh {

namespace {

/// The window promises five pictures of the evolving contour per second.
constexpr double kSnapshotSeconds = 0.17;

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
  RunOptions options;
  options.until = until_;
  options.snapshots = snapshots_;
  options.snapshotSeconds = kSnapshotSeconds;
  options.control = control_;
  options.keepOnFailure = true;
  options.begins = [this](Step step) {
    if (step > lastWanted_) {
      end_ = End::Stopped;
      return false;
    }
    step_ = step;
    return true;
  };
  options.warned = [this](Step step, const std::string& warning) {
    const std::lock_guard lock(mutex_);
    warnings_.emplace_back(step, warning);
  };
  options.done = [this](Step step, const RunResult& soFar) { collect(step, soFar); };
  const RunResult run = pipeline_->run(params_, options, progress_);
  if (run.failure) {
    end_ = End::Failed;
    error_ = run.failure->why;
  }
}

void RunJob::collect(Step step, const RunResult& soFar) {
  StepResult result;
  result.step = step;
  result.key = soFar.key;
  result.run = std::make_shared<const RunResult>(soFar);
  const std::lock_guard lock(mutex_);
  results_.push_back(std::move(result));
}

double RunJob::fraction() const { return std::min(progress_.fraction(), shareOf(step())[1]); }

double RunJob::stepFraction() const {
  const auto [from, to] = shareOf(step());
  return to <= from ? 1.0 : std::clamp((progress_.fraction() - from) / (to - from), 0.0, 1.0);
}

std::vector<std::pair<Step, std::string>> RunJob::takeWarnings() {
  const std::lock_guard lock(mutex_);
  return std::exchange(warnings_, {});
}

std::vector<StepResult> RunJob::takeResults() {
  const std::lock_guard lock(mutex_);
  return std::exchange(results_, {});
}

}  // namespace angiomesh

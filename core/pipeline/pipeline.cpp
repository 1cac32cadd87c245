// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <list>
#include <mutex>
#include <new>
#include <utility>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/parameters/field.h"
#include "core/pipeline/step_table.h"

namespace angiomesh {
namespace {

constexpr const char* kNoMemory =
    "not enough memory, surface: draw a smaller region of interest, or ask for longer edges "
    "(surface.edgeMinMm)";

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string keyPart(const Field& field, const Parameters& params) {
  return ";" + field.key + "=" + fieldText(field.get(params), field);
}

bool stoppedByHand(const RunResult& run) {
  return run.evolve && endedByHand(*run.evolve, run.params);
}

/// One remembered result of a step.
struct Entry {
  std::string key;
  StepValue value;
  StageReport report;
};

}  // namespace

struct Pipeline::State {
  /// Undo and redo find their results again; more would keep too many volumes.
  static constexpr std::size_t kRemembered = 3;

  Source source;
  mutable std::mutex mutex;
  std::array<std::list<Entry>, kStepCount> results;  ///< most recent first

  const Entry* find(Step step, const std::string& key) {
    auto& list = results[static_cast<std::size_t>(step)];
    const auto found =
        std::find_if(list.begin(), list.end(), [&key](const Entry& e) { return e.key == key; });
    if (found == list.end()) return nullptr;
    list.splice(list.begin(), list, found);
    return &list.front();
  }

  void remember(const StageReport& report, StepValue value) {
    const std::lock_guard lock(mutex);
    auto& list = results[static_cast<std::size_t>(report.step)];
    list.push_front({report.key, std::move(value), report});
    if (list.size() > kRemembered) list.pop_back();
  }

  /// The step's result into the run: the remembered one, or that of its function, which is then
  /// remembered. What follows from an evolution that was stopped by hand is neither.
  void perform(const StepRow& row, const std::string& key, StepWork& work) {
    RunResult& run = work.run;
    if (!recall(row, key, run)) {
      StageReport report;
      report.step = row.step;
      report.key = key;
      work.warnings.clear();
      const Clock::time_point start = Clock::now();
      const double cpu = cpuSeconds();
      StepValue value = row.make(work);
      report.seconds = secondsSince(start);
      report.cpuSeconds = cpuSeconds() - cpu;
      report.warnings = std::exchange(work.warnings, {});
      run.stages.push_back(report);
      row.store(run, value);
      if (!stoppedByHand(run) && work.options.keepResults) remember(report, std::move(value));
    }
    if (row.finish != nullptr) row.finish(run);
  }

  [[nodiscard]] StepValue recalled(Step step, const std::string& key) {
    const std::lock_guard lock(mutex);
    const Entry* known = find(step, key);
    return known != nullptr ? known->value : StepValue();
  }

  bool recall(const StepRow& row, const std::string& key, RunResult& run) {
    if (stoppedByHand(run)) return false;
    const std::lock_guard lock(mutex);
    const Entry* known = find(row.step, key);
    if (known == nullptr) return false;
    run.stages.push_back(known->report);
    run.stages.back().reused = true;
    row.store(run, known->value);
    return true;
  }
};

Pipeline::Pipeline(Source source) : state_(std::make_unique<State>()) {
  state_->source = std::move(source);
}

Pipeline::~Pipeline() = default;

const Source& Pipeline::source() const { return state_->source; }

std::string Pipeline::key(Step step, const Parameters& params) const {
  const auto reader = isSegmented(params) ? &Field::ofMask : &Field::ofScan;
  std::string text = state_->source.hash;
  for (const StepRow& row : stepTable()) {
    if (row.step > step) break;
    // What corrects nothing leaves all keys as they are.
    if (row.step == Step::Correct && params.segmentation.corrections.empty()) continue;
    text += std::string("|") + stepId(row.step) + std::to_string(factsOf(row.step).version);
    for (const Field& field : parameterFields())
      if (field.*reader == row.step && field.remakes) text += keyPart(field, params);
  }
  return textHash(text);
}

std::string Pipeline::speedKey(const Parameters& params) const {
  std::string text = key(Step::Vesselness, params) + "|speed";
  for (const Field& field : parameterFields())
    if (field.ofSpeed) text += keyPart(field, params);
  return textHash(text);
}

bool Pipeline::has(Step step, const Parameters& params) const {
  if (step == Step::Load) return true;
  const std::string wanted = key(step, params);
  const std::lock_guard lock(state_->mutex);
  return state_->find(step, wanted) != nullptr;
}

bool Pipeline::needs(Step step, const Parameters& params, Step until) const {
  if (step > until || (factsOf(step).ofScans && isSegmented(params))) return false;
  return !factsOf(step).feedsEvolution || until < Step::Evolve || !has(Step::Evolve, params) ||
         has(step, params);
}

Step Pipeline::deepestAtHand(const Parameters& params) const {
  Step deepest = Step::Load;
  for (const StepRow& row : stepTable()) {
    if (has(row.step, params))
      deepest = row.step;
    else if (needs(row.step, params))
      break;
  }
  return deepest;
}

bool Pipeline::restore(std::shared_ptr<const EvolveResult> evolve, const StageReport& report,
                       const Parameters& params) {
  if (report.step != Step::Evolve || report.key != key(Step::Evolve, params)) return false;
  state_->remember(report, std::move(evolve));
  return true;
}

RunResult Pipeline::run(const Parameters& params, const RunOptions& options,
                        const Progress& progress) {
  validate(params);
  const Clock::time_point start = Clock::now();
  const double cpu = cpuSeconds();
  RunResult run;
  run.params = params;
  run.source = state_->source;
  run.key = state_->source.hash;
  StepWork work{options, run, progress, {}, [&](Step step, const Parameters& other) {
                  return stoppedByHand(run) ? StepValue()
                                            : state_->recalled(step, key(step, other));
                }};
  for (const StepRow& row : stepTable()) {
    progress.check();
    if (row.step > options.until) break;
    const bool needed = needs(row.step, params, options.until);
    if (needed && options.begins && !options.begins(row.step)) break;
    const std::string before = std::exchange(run.key, key(row.step, params));
    progress.phase(stepId(row.step));
    if (!needed) continue;
    const auto failed = [&](std::string why) {
      if (!options.keepOnFailure || row.step < Step::Surface) throw;
      run.failure = {row.step, std::move(why)};
      run.key = before;
    };
    try {
      const auto [from, to] = shareOf(row.step);
      work.progress = progress.sub(from, to);
      state_->perform(row, run.key, work);
    } catch (const Error& error) {
      failed(error.what());
    } catch (const std::bad_alloc&) {
      failed(kNoMemory);
    }
    run.totalSeconds = secondsSince(start);
    run.cpuSeconds = cpuSeconds() - cpu;
    if (run.failure) break;
    if (options.done) options.done(row.step, run);
  }
  progress.report(1.0);
  run.totalSeconds = secondsSince(start);
  run.cpuSeconds = cpuSeconds() - cpu;
  return run;
}

}  // namespace angiomesh

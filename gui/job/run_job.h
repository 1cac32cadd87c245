// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// The meshes that the inspector compares: those of a run, and one from a file.
enum class MeshKind { Exported, Unsmoothed, MarchingCubes, File };
constexpr int kMeshKindCount = 4;
constexpr int kRunMeshCount = 3;  ///< those before File

/// Whether our mesher made it.
constexpr bool isOurs(MeshKind kind) {
  return kind == MeshKind::Exported || kind == MeshKind::Unsmoothed;
}

/// A step's result and those before it.
struct StepResult {
  Step step = Step::Load;
  std::string key;
  std::shared_ptr<const RunResult> run;
};

/// One run of the pipeline as its worker and its watcher share it: execute() runs on the worker,
/// all else may be called from the watcher's thread at any time. Results arrive step by step.
class RunJob {
 public:
  RunJob(std::shared_ptr<Pipeline> pipeline, const Parameters& params, Step until);

  void execute() noexcept;

  void cancel() { progress_.cancel(); }
  /// Lets the step in work end, and no other begin.
  void stopAfterStep() { lastWanted_ = std::min(lastWanted_.load(), step()); }

  enum class End { Done, Stopped, Cancelled, Failed };
  /// How it ended, and why when it failed: after execute() only.
  [[nodiscard]] End end() const { return end_; }
  [[nodiscard]] const std::string& error() const { return error_; }

  [[nodiscard]] const Parameters& params() const { return params_; }
  [[nodiscard]] Step until() const { return until_; }
  /// The step in work.
  [[nodiscard]] Step step() const { return step_; }
  /// Of the whole run, and of the step in work: 0..1.
  [[nodiscard]] double fraction() const;
  [[nodiscard]] double stepFraction() const;
  /// Iterations and change.
  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] EvolutionControl& control() { return *control_; }

  /// What has arrived since the last call.
  std::vector<StepResult> takeResults();
  /// Of what a step in work will cost, since the last call.
  std::vector<std::pair<Step, std::string>> takeWarnings();
  std::shared_ptr<const EvolutionSnapshot> takeSnapshot() { return snapshots_->take(); }

 private:
  void runSteps();
  void collect(Step step, const RunResult& soFar);

  std::shared_ptr<Pipeline> pipeline_;
  Parameters params_;
  Step until_;
  std::shared_ptr<EvolutionControl> control_ = std::make_shared<EvolutionControl>();
  std::shared_ptr<Mailbox<EvolutionSnapshot>> snapshots_ =
      std::make_shared<Mailbox<EvolutionSnapshot>>();
  Progress progress_;
  std::atomic<Step> step_{Step::Preprocess};  ///< in work
  std::atomic<Step> lastWanted_;
  mutable std::mutex mutex_;
  std::vector<StepResult> results_;                     ///< guarded by mutex_
  std::vector<std::pair<Step, std::string>> warnings_;  ///< guarded by mutex_
  End end_ = End::Done;
  std::string error_;
};

}  // namespace angiomesh

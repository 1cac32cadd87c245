// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/levelset/packed_front.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// Where the front of an evolution was.
struct KeptFront {
  int iterations = 0;
  PackedFront phi;
};

/// The zero level set while it evolves.
struct EvolutionSnapshot {
  int iterations = 0;
  double change = -1.0;
  std::shared_ptr<const Volume<float>> phi;  ///< sparse-field phi, working voxels
  /// Its zero set, or that of an earlier phi while the new one is being made; null before the
  /// first.
  std::shared_ptr<const TriMesh> surface;
  std::vector<float> motions;  ///< of each iteration, see LevelSetEvolution::motions()
  /// Fronts that it has been at, the first one first: a few, evenly over the iterations.
  std::vector<std::shared_ptr<const KeptFront>> kept;
};

/// A one-place mailbox: a newer value replaces one that was not taken.
template <class T>
class Mailbox {
 public:
  void post(std::shared_ptr<const T> value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  std::shared_ptr<const T> take() {
    const std::lock_guard lock(mutex_);
    return std::move(value_);
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

/// Lets a watcher of the evolution pause, single-step and end it. All members may be set from any
/// thread.
struct EvolutionControl {
  std::atomic<bool> paused{false};
  std::atomic<int> stepsWanted{0};     ///< while paused: run so many iterations, then pause again
  std::atomic<bool> finishNow{false};  ///< take the surface as it stands (stop_reason "stopped")
};

struct RunOptions {
  Step until = Step::Quality;
  std::shared_ptr<Mailbox<EvolutionSnapshot>> snapshots;  ///< empty: none are made
  double snapshotSeconds = 0.2;                           ///< least time between two
  bool frontsAlone = false;  ///< of snapshots: no surface is made, and no earlier front kept
  std::shared_ptr<EvolutionControl> control;
  /// Else the pipeline remembers no step's result, and that of the vesselness, which nothing after
  /// the evolution needs, is empty if the run goes so far.
  bool keepResults = true;
  /// A failure of the step surface or a later one is not thrown: it is in the result, with all that
  /// was computed before.
  bool keepOnFailure = false;
  // Called from within run().
  /// Before each step; false ends the run there, with what there is.
  std::function<bool(Step step)> begins;
  /// With each warning that tells beforehand what a step will cost.
  std::function<void(Step step, const std::string& warning)> warned;
  /// After each step, with its results and those before: what happens later takes none of them
  /// away.
  std::function<void(Step step, const RunResult& soFar)> done;
};

}  // namespace angiomesh

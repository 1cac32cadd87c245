// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/clock.h"
#include "core/base/progress.h"
#include "core/levelset/evolution.h"
#include "core/pipeline/run_options.h"

namespace angiomesh {

/// Posts a level set as it evolves: phi at once, its surface as soon as that is made. The surface
/// is made on a thread of its own, so that the evolution waits for a copy of phi only.
class LiveSnapshots {
 public:
  /// By the options' snapshots and frontsAlone.   @param progress ends the making of a surface
  LiveSnapshots(const RunOptions& options, const Progress& progress);
  /// Waits for the surface of the last snapshot.
  ~LiveSnapshots();
  LiveSnapshots(const LiveSnapshots&) = delete;
  LiveSnapshots& operator=(const LiveSnapshots&) = delete;

  void post(const LevelSetEvolution& evolution);
  /// Keeps the front as it is, to go back to, unless that would take more than a tenth of the
  /// evolution's time.
  void keep(const LevelSetEvolution& evolution);

 private:
  static constexpr std::size_t kMostKept = 32;
  static constexpr double kKeepingShare = 0.1;

  void makeSurfaces();
  void thinOut();

  std::shared_ptr<Mailbox<EvolutionSnapshot>> mailbox_;
  bool frontsAlone_;
  Progress progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Of the evolution's thread.
  std::vector<std::shared_ptr<const KeptFront>> kept_;
  int keptEvery_ = 1;  ///< iterations
  Clock::time_point began_ = Clock::now();
  double keepingSeconds_ = 0.0;
  // Guarded by mutex_.
  std::shared_ptr<const EvolutionSnapshot> last_;  ///< posted
  bool wanted_ = false;                            ///< a surface of last_
  bool ends_ = false;
  std::jthread maker_;
};

}  // namespace angiomesh

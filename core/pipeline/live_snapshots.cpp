// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/live_snapshots.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/contour/marching_cubes.h"

namespace angiomesh {

LiveSnapshots::LiveSnapshots(const RunOptions& options, const Progress& progress)
    : mailbox_(options.snapshots),
      frontsAlone_(options.frontsAlone),
      progress_(progress.sub(0.0, 0.0)) {
  if (mailbox_ && !frontsAlone_) maker_ = std::jthread([this] { makeSurfaces(); });
}

LiveSnapshots::~LiveSnapshots() {
  const std::lock_guard lock(mutex_);
  ends_ = true;
  changed_.notify_one();
}

void LiveSnapshots::post(const LevelSetEvolution& evolution) {
  if (!mailbox_) return;
  auto snapshot = std::make_shared<EvolutionSnapshot>();
  snapshot->iterations = evolution.iterations();
  snapshot->change = evolution.change();
  snapshot->motions = evolution.motions();
  snapshot->kept = kept_;
  snapshot->phi = std::make_shared<const Volume<float>>(evolution.phi());
  const std::lock_guard lock(mutex_);
  if (last_) snapshot->surface = last_->surface;
  last_ = snapshot;
  wanted_ = true;
  mailbox_->post(last_);
  changed_.notify_one();
}

void LiveSnapshots::keep(const LevelSetEvolution& evolution) {
  if (!mailbox_ || frontsAlone_) return;
  const Clock::time_point start = Clock::now();
  if (!kept_.empty() && (evolution.iterations() < kept_.back()->iterations + keptEvery_ ||
                         keepingSeconds_ > kKeepingShare * secondsSince(began_)))
    return;
  kept_.push_back(std::make_shared<const KeptFront>(
      KeptFront{evolution.iterations(), PackedFront(evolution.phi())}));
  keepingSeconds_ += secondsSince(start);
  if (kept_.size() > kMostKept) thinOut();
}

/// Every other one goes, and from now on fronts lie twice as far apart.
void LiveSnapshots::thinOut() {
  keptEvery_ = std::max(2 * keptEvery_, kept_[2]->iterations - kept_[0]->iterations);
  std::size_t n = 0;
  std::erase_if(kept_, [&n](const auto&) { return n++ % 2 == 1; });
}

void LiveSnapshots::makeSurfaces() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return wanted_ || ends_; });
    if (!std::exchange(wanted_, false)) return;
    const std::shared_ptr<const Volume<float>> phi = last_->phi;
    std::shared_ptr<const TriMesh> surface;
    lock.unlock();
    try {
      surface = std::make_shared<const TriMesh>(marchingCubes(*phi, SurfaceBorder::Cap, progress_));
    } catch (const std::exception&) {
      // Cancelled, or no memory: the evolution itself will say so.
    }
    lock.lock();
    if (!surface) continue;
    // phi may have moved on meanwhile.
    auto snapshot = std::make_shared<EvolutionSnapshot>(*last_);
    snapshot->surface = std::move(surface);
    last_ = snapshot;
    mailbox_->post(last_);
  }
}

}  // namespace angiomesh

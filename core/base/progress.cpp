// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/progress.h"

#include <algorithm>
#include <atomic>

#include "core/base/error.h"

namespace angiomesh {

struct Progress::State {
  std::atomic<double> fraction{0.0};
  std::atomic<const char*> phase{""};
  std::atomic<int> iterations{0};
  std::atomic<double> change{-1.0};
  std::atomic<bool> cancelled{false};
};

Progress::Progress() : state_(std::make_shared<State>()) {}

Progress Progress::sub(double from, double to) const {
  Progress part = *this;
  part.from_ = from_ + (to_ - from_) * from;
  part.to_ = from_ + (to_ - from_) * to;
  return part;
}

void Progress::report(double fraction) const {
  const double value = from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0);
  double seen = state_->fraction.load(std::memory_order_relaxed);
  while (value > seen && !state_->fraction.compare_exchange_weak(seen, value)) {
  }
  check();
}

void Progress::check() const {
  if (cancelled()) throw Cancelled();
}

void Progress::phase(const char* name) const { state_->phase.store(name); }

void Progress::evolution(int iterations, double change) const {
  state_->iterations.store(iterations);
  state_->change.store(change);
}

void Progress::cancel() const { state_->cancelled.store(true); }

bool Progress::cancelled() const { return state_->cancelled.load(std::memory_order_relaxed); }
double Progress::fraction() const { return state_->fraction.load(); }
const char* Progress::phase() const { return state_->phase.load(); }
int Progress::iterations() const { return state_->iterations.load(); }
double Progress::change() const { return state_->change.load(); }

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/job_slot.h"

namespace angiomesh {

namespace {

constexpr int kPollMilliseconds = 33;

}  // namespace

JobTimer::JobTimer(QObject* parent) : QObject(parent) {
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &JobTimer::poll);
}

void JobTimer::wake() {
  wanted_ = true;
  // A timer that is started again with each move of a slider would never come to its end.
  if (!timer_.isActive()) timer_.start();
}

void JobTimer::poll() {
  // What ends may begin something that was looked at already, or call this again.
  const bool outermost = !std::exchange(polling_, true);
  if (outermost) wanted_ = false;
  const std::vector<Polled*> now = polled_;
  for (Polled* polled : now)
    if (polled->poll()) wanted_ = true;
  if (outermost) {
    polling_ = false;
    if (!wanted_) timer_.stop();
  }
  Q_EMIT ticked();
}

}  // namespace angiomesh

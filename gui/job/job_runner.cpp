// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/job_runner.h"

#include <sys/resource.h>

#include <utility>

namespace angiomesh {

namespace {

/// As `nice` does, of this thread and those that it will start: what the user does comes before
/// what runs meanwhile. Nothing is lost where the system refuses.
void giveWayToTheWindow() { (void)setpriority(PRIO_PROCESS, 0, 5); }

}  // namespace

void ThreadedJobRunner::start(std::function<void()> work) {
  wait();
  running_ = true;
  thread_ = std::jthread([this, work = std::move(work)] {
    giveWayToTheWindow();
    work();
    running_ = false;
  });
}

void ThreadedJobRunner::wait() {
  if (thread_.joinable()) thread_.join();
}

std::unique_ptr<JobRunner> makeThreadedJobRunner() { return std::make_unique<ThreadedJobRunner>(); }

std::unique_ptr<JobRunner> makeInlineJobRunner() { return std::make_unique<InlineJobRunner>(); }

}  // namespace angiomesh

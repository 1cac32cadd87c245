// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/job_runner.h"

#include <utility>

namespace angiomesh {

void ThreadedJobRunner::start(std::function<void()> work) {
  wait();
  running_ = true;
  thread_ = std::jthread([this, work = std::move(work)] {
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

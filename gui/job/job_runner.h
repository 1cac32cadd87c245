// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace angiomesh {

/// Runs one piece of work at a time. The work never touches a widget or a model: whoever started it
/// polls running() and then takes what the work left behind.
class JobRunner {
 public:
  virtual ~JobRunner() = default;
  /// @param work must not throw   @pre !running()
  virtual void start(std::function<void()> work) = 0;
  [[nodiscard]] virtual bool running() const = 0;
  /// Blocks until the work has ended.
  virtual void wait() = 0;
};

/// On a thread of its own.
class ThreadedJobRunner final : public JobRunner {
 public:
  void start(std::function<void()> work) override;
  [[nodiscard]] bool running() const override { return running_; }
  void wait() override;

 private:
  std::atomic<bool> running_{false};
  std::jthread thread_;
};

/// Inside start(), so that tests see the result at once.
class InlineJobRunner final : public JobRunner {
 public:
  void start(std::function<void()> work) override { work(); }
  [[nodiscard]] bool running() const override { return false; }
  void wait() override {}
};

using JobRunnerFactory = std::function<std::unique_ptr<JobRunner>()>;
std::unique_ptr<JobRunner> makeThreadedJobRunner();
std::unique_ptr<JobRunner> makeInlineJobRunner();

}  // namespace angiomesh

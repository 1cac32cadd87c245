// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "gui/job/job_runner.h"

namespace angiomesh {

/// Something that is looked at while work goes on.
class Polled {
 public:
  virtual ~Polled() = default;
  /// Whether it wants to be looked at again.
  virtual bool poll() = 0;
};

/// The one timer of all jobs: it runs at 30 Hz as long as one of them wants to be looked at.
class JobTimer : public QObject {
  Q_OBJECT

 public:
  explicit JobTimer(QObject* parent = nullptr);

  /// What is looked at, in the order of these calls; it must outlive the timer's ticks.
  void add(Polled& polled) { polled_.push_back(&polled); }
  void remove(Polled& polled) { std::erase(polled_, &polled); }
  /// From now on there is something to look at.
  void wake();
  void poll();

 Q_SIGNALS:
  void ticked();  ///< after everything was looked at

 private:
  QTimer timer_;
  std::vector<Polled*> polled_;
  bool polling_ = false;
  bool wanted_ = false;  ///< since the outermost poll() began
};

/// Room for one job of a kind, off the window's thread. A job has execute(), which must not throw;
/// what it is asked for is set before start(), and what it left behind taken in `finish`.
template <class Job>
class JobSlot final : public Polled {
 public:
  using Shared = std::shared_ptr<Job>;

  /// @param finish takes a job that has ended, on the window's thread
  /// @param watch looks at the job in work with each tick; may be empty
  JobSlot(JobTimer& timer, const JobRunnerFactory& makeRunner, std::function<void(Shared)> finish,
          std::function<void(Job&)> watch = {})
      : timer_(timer), runner_(makeRunner()), finish_(std::move(finish)), watch_(std::move(watch)) {
    timer_.add(*this);
  }
  /// Waits for the job. Cancel it before.
  ~JobSlot() override {
    timer_.remove(*this);
    runner_->wait();
  }
  JobSlot(const JobSlot&) = delete;
  JobSlot& operator=(const JobSlot&) = delete;

  [[nodiscard]] const Shared& job() const { return job_; }
  explicit operator bool() const { return job_ != nullptr; }

  /// @pre no job is in work
  void start(Shared job) {
    job_ = std::move(job);
    runner_->start([job = job_] { job->execute(); });
    timer_.wake();
  }

  /// Also takes the job at once if it has ended by then. @returns whether it is in work.
  bool startAndPoll(Shared job) {
    start(std::move(job));
    const bool inWork = runner_->running();
    if (!inWork) poll();
    return inWork;
  }

  bool poll() override {
    if (!job_) return false;
    const bool ended = !runner_->running();
    if (watch_) watch_(*job_);
    if (ended) finish_(std::exchange(job_, nullptr));
    return job_ != nullptr;
  }

  /// For one that finish must give back: it waits for something else.
  void keep(Shared job) { job_ = std::move(job); }

 private:
  JobTimer& timer_;
  std::unique_ptr<JobRunner> runner_;
  std::function<void(Shared)> finish_;
  std::function<void(Job&)> watch_;
  Shared job_;
};

}  // namespace angiomesh

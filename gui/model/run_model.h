// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gui/model/result_model.h"

namespace angiomesh {

enum class StepState { Empty, NotNeeded, Fresh, Running, Stale, Failed };

/// Runs the pipeline on the present parameters, follows their edits, and hands results on step by
/// step.
class RunModel : public QObject {
  Q_OBJECT

 public:
  RunModel(CaseDocument& document, ResultModel& results, MessageLog& log, JobTimer& timer,
           const JobRunnerFactory& makeRunner, QObject* parent = nullptr);
  /// Cancels what runs and waits for it.
  ~RunModel() override;

  void run(Step until = Step::Quality);
  void cancel();
  /// Of another case nothing is wanted any more. @returns whether a run has to let go first
  bool leave();
  void setPaused(bool paused);
  void stepEvolution(int iterations = 1);
  void finishEvolution();
  [[nodiscard]] bool running() const { return static_cast<bool>(slot_); }
  [[nodiscard]] bool evolving() const;
  [[nodiscard]] bool paused() const;

  [[nodiscard]] StepState state(Step step) const;
  /// Empty when nothing is computed.
  [[nodiscard]] std::optional<Step> stepInWork() const;
  /// Of the run, and of the step in work: 0..1.
  [[nodiscard]] double runFraction() const;
  [[nodiscard]] double stepFraction() const;
  /// Of the run, by what it has done so far; empty while that tells nothing.
  [[nodiscard]] std::optional<double> secondsLeft() const;
  /// Why a step failed; empty where it did not.
  [[nodiscard]] QString failure(Step step) const;
  [[nodiscard]] int iterations() const { return iterations_; }
  /// Last change of the evolution; negative without one.
  [[nodiscard]] double change() const { return change_; }
  /// Iterations and change at the checks of the evolution shown.
  [[nodiscard]] const std::vector<std::pair<int, double>>& history() const { return history_; }
  /// How far the front moved in each of its iterations, see LevelSetEvolution::motions().
  [[nodiscard]] const std::vector<float>& motions() const { return motions_; }
  /// Where it has been, the first one first.
  [[nodiscard]] const std::vector<std::shared_ptr<const KeptFront>>& keptFronts() const {
    return keptFronts_;
  }

  /// Forgets failures and the evolution, with the results.
  void clear();
  /// Shows what the pipeline remembers for the present parameters.
  void refreshFromCache();

 Q_SIGNALS:
  void statesChanged();    ///< of the steps, of running and pausing
  void snapshotArrived();  ///< phi and surface of the evolution moved on
  void ended();            ///< a run that somebody asked for

 private:
  void startRun(Step until);
  void fail(Step step, const Parameters& params, const std::string& reason);
  void interrupt();
  void watch(RunJob& job);
  void watchEvolution(const RunJob& job, const EvolutionSnapshot* snapshot);
  void forgetEvolution();
  void noteEvolution();
  void tell(const StepResult& result);
  void sayEvolved(const RunResult& run);
  void finish(const RunJob& job);
  void sayEnd(const RunJob& job);

  CaseDocument& document_;
  ResultModel& results_;
  MessageLog& log_;
  JobTimer& timer_;
  bool quiet_ = false;                   ///< a look into the cache, not worth a line in the log
  bool leaving_ = false;                 ///< another case waits for the run to let go
  std::optional<Step> polledStep_;       ///< of the run, when last looked at
  std::optional<Step> interruptAfter_;   ///< this step the run is of no more use
  std::optional<Step> runAgain_;         ///< once the present run has ended
  QElapsedTimer since_;                  ///< the run that is on has begun to compute
  double fractionThen_ = -1.0;           ///< of the run, when since_ began; negative: not yet
  std::vector<std::string> saidBefore_;  ///< warnings that came before the step's result
  std::string failedKey_;
  Step failedStep_ = Step::Load;
  QString failedText_;
  int iterations_ = 0;
  double change_ = -1.0;
  QString evolutionOf_;  ///< name of the segmentation that the following come from
  std::vector<std::pair<int, double>> history_;
  std::vector<float> motions_;
  std::vector<std::shared_ptr<const KeptFront>> keptFronts_;
  JobSlot<RunJob> slot_;
};

}  // namespace angiomesh

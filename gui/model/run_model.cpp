// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/run_model.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

// Before, a guess at the time left would be worth nothing.
constexpr double kLeastSeconds = 2.0;
constexpr double kLeastShare = 0.05;

QString stopText(const RunResult& run) {
  switch (run.evolve->stopReason) {
    case StopReason::Converged:
      return RunModel::tr("converged");
    case StopReason::Settled:
      return RunModel::tr("settled");
    case StopReason::Limit:
      return RunModel::tr("not converged at the limit");
    case StopReason::Stopped:
      return endedByHand(*run.evolve, run.params)
                 ? RunModel::tr("finished by hand (a next run evolves again)")
                 : RunModel::tr("ended as asked");
    case StopReason::Running:
      break;
  }
  return {};
}

}  // namespace

RunModel::RunModel(CaseDocument& document, ResultModel& results, MessageLog& log, JobTimer& timer,
                   const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      document_(document),
      results_(results),
      log_(log),
      timer_(timer),
      slot_(
          timer, makeRunner, [this](const std::shared_ptr<RunJob>& job) { finish(*job); },
          [this](RunJob& job) { watch(job); }) {
  connect(&document_, &CaseDocument::edited, this, [this] {
    interrupt();
    refreshFromCache();
    Q_EMIT statesChanged();
  });
}

RunModel::~RunModel() {
  if (slot_) slot_.job()->cancel();
}

void RunModel::run(Step until) {
  if (!document_.hasCase()) return;
  if (slot_) {
    runAgain_ = until;
    slot_.job()->stopAfterStep();
    return;
  }
  quiet_ = false;
  try {
    validate(document_.parameters());
  } catch (const Error& failure) {
    // Edits keep all relations between fields but one: that there are seeds.
    fail(Step::Seeds, document_.parameters(), failure.what());
    Q_EMIT statesChanged();
    return;
  }
  startRun(until);
}

void RunModel::fail(Step step, const Parameters& params, const std::string& reason) {
  failedStep_ = step;
  failedKey_ = document_.pipeline()->key(step, params);
  failedText_ = QString::fromStdString(reason).simplified();
  log_.say(Severity::Error, tr("%1 failed: %2").arg(stepTitle(step), failedText_));
}

void RunModel::startRun(Step until) {
  // What was corrected belongs to a segmentation, of which it may be the last chance where the
  // evolution is ended by hand.
  if (until == Step::Evolve && !document_.parameters().segmentation.corrections.empty())
    until = Step::Correct;
  failedKey_.clear();
  polledStep_.reset();
  saidBefore_.clear();
  interruptAfter_.reset();
  fractionThen_ = -1.0;
  results_.cancelEstimate();
  if (!quiet_) results_.showFront(nullptr);
  results_.setRunning(true);
  slot_.start(std::make_shared<RunJob>(document_.pipeline(), document_.parameters(), until));
  Q_EMIT statesChanged();
  timer_.poll();
}

void RunModel::cancel() {
  if (slot_) {
    runAgain_.reset();
    slot_.job()->cancel();
  }
}

bool RunModel::leave() {
  cancel();
  leaving_ = running();
  return leaving_;
}

void RunModel::setPaused(bool paused) {
  if (slot_) {
    slot_.job()->control().paused = paused;
    // The pause is no time of the run's.
    fractionThen_ = runFraction();
    since_.restart();
    Q_EMIT statesChanged();
  }
}

void RunModel::stepEvolution(int iterations) {
  if (slot_) slot_.job()->control().stepsWanted += iterations;
}

void RunModel::finishEvolution() {
  if (slot_) {
    slot_.job()->control().finishNow = true;
    slot_.job()->control().paused = false;
    Q_EMIT statesChanged();
  }
}

bool RunModel::evolving() const { return slot_ && slot_.job()->step() == Step::Evolve && !quiet_; }

bool RunModel::paused() const { return slot_ && slot_.job()->control().paused; }

StepState RunModel::state(Step step) const {
  if (!document_.hasCase()) return StepState::Empty;
  if (factsOf(step).ofScans && isSegmented(document_.parameters())) return StepState::NotNeeded;
  const std::string& now = document_.key(step);
  const std::string& shown = results_.key(step);
  const Pipeline& pipeline = *document_.pipeline();
  const auto ofRun = [&](const Parameters& params) {
    if (params != document_.parameters() && pipeline.key(step, params) != now) return false;
    // What follows from an evolution that was ended by hand has a key, but is computed again.
    return shown != now || !pipeline.has(step, params);
  };
  if (slot_ && !quiet_ && ofRun(slot_.job()->params())) {
    const Step atWork = slot_.job()->step();
    if (step == atWork) return StepState::Running;
    if (step < atWork) return StepState::Fresh;  // computed, and on its way here
  }
  if (!failedKey_.empty() && step == failedStep_ && failedKey_ == now) return StepState::Failed;
  if (shown.empty()) return StepState::Empty;
  return shown == now ? StepState::Fresh : StepState::Stale;
}

std::optional<Step> RunModel::stepInWork() const {
  return slot_ && !quiet_ ? std::optional(slot_.job()->step()) : std::nullopt;
}

double RunModel::runFraction() const { return slot_ ? slot_.job()->fraction() : 0.0; }

std::optional<double> RunModel::secondsLeft() const {
  if (!slot_ || quiet_ || paused() || fractionThen_ < 0.0) return std::nullopt;
  const double end = shareOf(slot_.job()->until())[1];
  const double done = runFraction() - fractionThen_;
  const double seconds = 1e-3 * static_cast<double>(since_.elapsed());
  if (seconds < kLeastSeconds || done < kLeastShare * (end - fractionThen_)) return std::nullopt;
  return seconds * (end - runFraction()) / done;
}

double RunModel::stepFraction() const { return slot_ ? slot_.job()->stepFraction() : 0.0; }

QString RunModel::failure(Step step) const {
  return state(step) == StepState::Failed ? failedText_ : QString();
}

void RunModel::clear() {
  failedKey_.clear();
  forgetEvolution();
}

void RunModel::forgetEvolution() {
  iterations_ = 0;
  change_ = -1.0;
  history_.clear();
  motions_.clear();
  keptFronts_.clear();
}

/// What is known of an evolution goes when the result of another one is shown.
void RunModel::noteEvolution() {
  const QString shown = results_.segmentationName();
  if (results_.report(Step::Evolve).reused && shown != evolutionOf_) forgetEvolution();
  evolutionOf_ = shown;
}

void RunModel::interrupt() {
  if (!slot_) return;
  RunJob& job = *slot_.job();
  const Pipeline& pipeline = *document_.pipeline();
  if (pipeline.key(job.until(), job.params()) == document_.key(job.until())) return;
  if (!quiet_) runAgain_ = runAgain_.value_or(job.until());
  // The step in work goes on where the change does not reach it.
  const Step step = job.step();
  if (pipeline.key(step, job.params()) == document_.key(step)) {
    job.stopAfterStep();
    interruptAfter_ = step;
  } else {
    job.cancel();
  }
}

void RunModel::refreshFromCache() {
  if (!document_.hasCase() || slot_) return;
  Step deepest = document_.pipeline()->deepestAtHand(document_.parameters());
  // Corrections are made at once.
  if (deepest == Step::Evolve) deepest = Step::Correct;
  for (Step step = Step::Preprocess; step <= deepest; step = stepAfter(step)) {
    const bool wanted =
        step == Step::Correct || document_.pipeline()->has(step, document_.parameters());
    if (wanted && !results_.fresh(step)) {
      quiet_ = true;
      startRun(deepest);
      return;
    }
  }
}

void RunModel::watch(RunJob& job) {
  if (interruptAfter_ && job.step() > *interruptAfter_) job.cancel();
  for (const auto& [step, warning] : job.takeWarnings()) {
    saidBefore_.push_back(warning);
    log_.say(Severity::Warning, stepTitle(step) + ": " + QString::fromStdString(warning));
  }
  // What is remembered is passed over in no time, and tells nothing of what is not.
  if (fractionThen_ < 0.0 && job.fraction() > 0.0) {
    fractionThen_ = shareOf(job.step())[0];
    since_.start();
  }
  // The last one may have been posted after the evolution was last seen.
  const std::shared_ptr<const EvolutionSnapshot> snapshot = job.takeSnapshot();
  if (snapshot) {
    motions_ = snapshot->motions;
    keptFronts_ = snapshot->kept;
  }
  bool arrived = false;
  for (const StepResult& result : job.takeResults()) {
    if (document_.key(result.step) == result.key) {
      results_.accept(result);
      if (result.step == Step::Evolve) noteEvolution();
      tell(result);
      arrived = true;
    }
  }
  if (evolving()) watchEvolution(job, snapshot.get());
  const std::optional<Step> step = job.step();
  const bool moved = std::exchange(polledStep_, step) != step;
  if (arrived) Q_EMIT results_.resultsChanged();
  if (arrived || moved) Q_EMIT statesChanged();
}

void RunModel::watchEvolution(const RunJob& job, const EvolutionSnapshot* snapshot) {
  const int iterations = job.progress().iterations();
  const double change = job.progress().change();
  if (iterations < iterations_) history_.clear();
  if (change >= 0.0 && change != change_) {
    // The check was at the last multiple; polling comes later.
    const int every = std::max(job.params().levelset.checkEvery, 1);
    history_.emplace_back(iterations / every * every, change);
  }
  iterations_ = iterations;
  change_ = change;
  if (snapshot != nullptr) {
    results_.setLive(snapshot->phi, snapshot->surface);
    Q_EMIT snapshotArrived();
  }
}

void RunModel::tell(const StepResult& result) {
  if (result.step == Step::Evolve) iterations_ = result.run->evolve->iterations;
  if (quiet_) return;
  for (const std::string& warning : results_.report(result.step).warnings)
    if (std::find(saidBefore_.begin(), saidBefore_.end(), warning) == saidBefore_.end())
      log_.say(Severity::Warning, stepTitle(result.step) + ": " + QString::fromStdString(warning));
  if (result.step == Step::Evolve) sayEvolved(*result.run);
}

void RunModel::sayEvolved(const RunResult& run) {
  const EvolveResult& evolve = *run.evolve;
  if (evolve.label) {
    log_.say(Severity::Info, tr("Evolve: label %1, %2 voxels, moved by at most %3 voxel.")
                                 .arg(run.params.segmentation.label)
                                 .arg(evolve.label->voxels)
                                 .arg(evolve.label->largestShiftVoxels, 0, 'f', 2));
  } else if (run.params.segmentation.method == SegmentationMethod::LevelSet) {
    log_.say(Severity::Info, tr("Evolve: %1 after %2 iterations, threshold b = %3.")
                                 .arg(stopText(run))
                                 .arg(evolve.iterations)
                                 .arg(evolve.thresholds.b, 0, 'g', 3));
  } else {
    log_.say(Severity::Info, tr("Evolve: segmented by another method than the level set."));
  }
}

void RunModel::finish(const RunJob& job) {
  results_.setRunning(false);
  const bool live = results_.setLive(nullptr, nullptr);
  const bool quiet = std::exchange(quiet_, false);
  if (job.end() == RunJob::End::Failed)
    fail(job.step(), job.params(), job.error());
  else if (!quiet)
    sayEnd(job);
  if (live) Q_EMIT results_.resultsChanged();
  if (!quiet) Q_EMIT ended();
  Q_EMIT statesChanged();
  if (std::exchange(leaving_, false)) return;
  if (runAgain_)
    run(*std::exchange(runAgain_, std::nullopt));
  else if (job.end() != RunJob::End::Failed)
    refreshFromCache();
}

void RunModel::sayEnd(const RunJob& job) {
  if (job.end() == RunJob::End::Cancelled && !runAgain_) {
    log_.say(Severity::Info, tr("Cancelled in step %1.").arg(stepTitle(job.step())));
  } else if (job.end() == RunJob::End::Done) {
    const std::shared_ptr<const TriMesh> mesh = results_.mesh(MeshKind::Exported);
    QString text = tr("Done up to %1").arg(stepTitle(job.until()));
    if (mesh && job.until() >= Step::Smooth) {
      text += tr(", %1 triangles, %2 s")
                  .arg(mesh->triangles.size())
                  .arg(results_.meshRun()->totalSeconds, 0, 'f', 1);
    }
    log_.say(Severity::Info, text + '.');
  }
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/parameters/field.h"
#include "gui/model/case_controller.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

QString stopText(StopReason reason) {
  switch (reason) {
    case StopReason::Converged:
      return CaseController::tr("converged");
    case StopReason::Settled:
      return CaseController::tr("settled");
    case StopReason::Limit:
      return CaseController::tr("not converged at the limit");
    case StopReason::Stopped:
      return CaseController::tr("finished by hand (a next run evolves again)");
    case StopReason::Running:
      break;
  }
  return {};
}

}  // namespace

/// The speed layer, made off the window's thread.
struct CaseController::SpeedJob {
  std::shared_ptr<const VesselnessResult> vesselness;
  LevelSetParams params;
  std::string key;
  std::shared_ptr<const Volume<float>> speed;
  std::string error;

  void execute() noexcept {
    try {
      const Thresholds t = thresholdsFor(*vesselness, params);
      speed = std::make_shared<const Volume<float>>(speedVolume(*vesselness->multiScale, t));
    } catch (const std::exception& failure) {
      error = failure.what();
    }
  }
};

void CaseController::run(Step until) {
  if (!pipeline_) {
    return;
  }
  if (run_) {
    runAgain_ = until;
    run_->stopAfterStep();
    return;
  }
  quietRun_ = false;
  try {
    validate(params_);
  } catch (const Error& failure) {
    // Edits keep all relations between fields but one: that there are seeds.
    fail(Step::Seeds, params_, failure.what());
    Q_EMIT statesChanged();
    return;
  }
  startRun(until);
}

void CaseController::fail(Step step, const Parameters& params, const std::string& reason) {
  failedStep_ = step;
  failedKey_ = pipeline_->key(step, params);
  failedText_ = QString::fromStdString(reason).simplified();
  say(Severity::Error, tr("%1 failed: %2").arg(stepTitle(step), failedText_));
}

void CaseController::startRun(Step until) {
  failedKey_.clear();
  polledStep_.reset();
  saidBefore_.clear();
  interruptAfter_.reset();
  cancelEstimate();
  run_ = std::make_shared<RunJob>(pipeline_, params_, until);
  runRunner_->start([job = run_] { job->execute(); });
  timer_.start();
  Q_EMIT statesChanged();
  poll();
}

void CaseController::cancel() {
  if (load_) {
    load_->progress().cancel();
  }
  if (run_) {
    runAgain_.reset();
    run_->cancel();
  }
}

void CaseController::setPaused(bool paused) {
  if (run_) {
    run_->control().paused = paused;
    Q_EMIT statesChanged();
  }
}

void CaseController::stepEvolution(int iterations) {
  if (run_) {
    run_->control().stepsWanted += iterations;
  }
}

void CaseController::finishEvolution() {
  if (run_) {
    run_->control().finishNow = true;
    run_->control().paused = false;
    Q_EMIT statesChanged();
  }
}

bool CaseController::evolving() const { return run_ && run_->step() == Step::Evolve && !quietRun_; }

bool CaseController::paused() const { return run_ && run_->control().paused; }

void CaseController::interruptRun() {
  if (!run_) {
    return;
  }
  if (pipeline_->key(run_->until(), run_->params()) == pipeline_->key(run_->until(), params_)) {
    return;
  }
  if (!quietRun_) {
    runAgain_ = runAgain_.value_or(run_->until());
  }
  // The step in work goes on where the change does not reach it.
  const Step step = run_->step();
  if (pipeline_->key(step, run_->params()) == pipeline_->key(step, params_)) {
    run_->stopAfterStep();
    interruptAfter_ = step;
  } else {
    run_->cancel();
  }
}

void CaseController::refreshFromCache() {
  if (!pipeline_ || run_) {
    return;
  }
  bool wanted = false;
  Step deepest = Step::Load;
  for (int i = static_cast<int>(Step::Preprocess); i < kStepCount; ++i) {
    const Step step = static_cast<Step>(i);
    if (!pipeline_->has(step, params_)) {
      if (step != Step::Preprocess && step < Step::Evolve &&
          (isSegmented(params_) || pipeline_->has(Step::Evolve, params_))) {
        continue;  // not needed: see Pipeline::restore()
      }
      break;
    }
    deepest = step;
    wanted = wanted || keys_[static_cast<std::size_t>(i)] != pipeline_->key(step, params_);
  }
  if (wanted) {
    quietRun_ = true;
    startRun(deepest);
  }
}

void CaseController::poll() {
  if (run_) {
    pollRun();
  }
  if (export_ && !exportRunner_->running()) {
    finishExport();
  }
  if (speedRun_ && !speedRunner_->running()) {
    finishSpeed();
    Q_EMIT resultsChanged();
  }
  if (estimateRun_ && !estimateRunner_->running()) {
    finishEstimate();
    Q_EMIT resultsChanged();
  }
  if (load_ && !loadRunner_->running()) {
    finishLoad();
  }
  pollStore();
  if (!busy()) {
    timer_.stop();
  }
  Q_EMIT progressChanged();
}

void CaseController::pollRun() {
  const std::shared_ptr<RunJob> job = run_;
  const bool ended = !runRunner_->running();
  if (interruptAfter_ && job->step() > *interruptAfter_) {
    job->cancel();
  }
  bool arrived = false;
  for (const auto& [step, warning] : job->takeWarnings()) {
    saidBefore_.push_back(warning);
    say(Severity::Warning, stepTitle(step) + ": " + QString::fromStdString(warning));
  }
  for (const StepResult& result : job->takeResults()) {
    if (pipeline_->key(result.step, params_) == result.key) {
      accept(result);
      arrived = true;
    }
  }
  if (evolving()) {
    const int iterations = job->progress().iterations();
    const double change = job->progress().change();
    if (iterations < iterations_) {
      history_.clear();
    }
    if (change >= 0.0 && change != change_) {
      // The check was at the last multiple; polling comes later.
      const int every = std::max(job->params().levelset.checkEvery, 1);
      history_.emplace_back(iterations / every * every, change);
    }
    iterations_ = iterations;
    change_ = change;
    if (const auto snapshot = job->takeSnapshot()) {
      livePhi_ = snapshot->phi;
      liveSurface_ = snapshot->surface;
      Q_EMIT snapshotArrived();
    }
  }
  const std::optional<Step> step = job->step();
  const bool moved = std::exchange(polledStep_, step) != step;
  if (arrived) {
    Q_EMIT resultsChanged();
  }
  if (arrived || moved) {
    Q_EMIT statesChanged();
  }
  if (ended) {
    finishRun();
  }
}

void CaseController::accept(const StepResult& result) {
  const RunResult& run = *result.run;
  keys_[static_cast<std::size_t>(result.step)] = result.key;
  shown_.stages.resize(kStepCount);
  for (const StageReport& stage : run.stages) {
    if (stage.step == result.step) {
      shown_.stages[static_cast<std::size_t>(result.step)] = stage;
      for (const std::string& warning : quietRun_ ? std::vector<std::string>() : stage.warnings) {
        if (std::find(saidBefore_.begin(), saidBefore_.end(), warning) == saidBefore_.end()) {
          say(Severity::Warning, stepTitle(result.step) + ": " + QString::fromStdString(warning));
        }
      }
    }
  }
  switch (result.step) {
    case Step::Preprocess:
      shown_.preprocessed = run.preprocessed;
      break;
    case Step::Vesselness:
      shown_.vesselness = run.vesselness;
      break;
    case Step::Seeds:
      shown_.seeds = run.seeds;
      break;
    case Step::Evolve:
      shown_.evolve = run.evolve;
      livePhi_.reset();
      iterations_ = run.evolve->iterations;
      if (!quietRun_) {
        if (run.evolve->label) {
          say(Severity::Info, tr("Evolve: label %1, %2 voxels, moved by at most %3 voxel.")
                                  .arg(run.params.segmentation.label)
                                  .arg(run.evolve->label->voxels)
                                  .arg(run.evolve->label->largestShiftVoxels, 0, 'f', 2));
        } else if (run.params.segmentation.method == SegmentationMethod::LevelSet) {
          say(Severity::Info, tr("Evolve: %1 after %2 iterations, threshold b = %3.")
                                  .arg(stopText(run.evolve->stopReason))
                                  .arg(run.evolve->iterations)
                                  .arg(run.evolve->thresholds.b, 0, 'g', 3));
        } else {
          say(Severity::Info, tr("Evolve: segmented by another method than the level set."));
        }
      }
      break;
    case Step::Surface:
    case Step::Smooth:
    case Step::Quality:
      meshRun_ = result.run;
      facts_ = result.facts;
      liveSurface_.reset();
      break;
    case Step::Load:
      break;
  }
}

void CaseController::finishRun() {
  const std::shared_ptr<RunJob> job = std::exchange(run_, nullptr);
  const bool live = livePhi_ || liveSurface_;
  livePhi_.reset();
  liveSurface_.reset();
  const bool quiet = std::exchange(quietRun_, false);
  if (job->end() == RunJob::End::Failed) {
    fail(job->step(), job->params(), job->error());
  } else if (job->end() == RunJob::End::Cancelled && !runAgain_ && !quiet) {
    say(Severity::Info, tr("Cancelled in step %1.").arg(stepTitle(job->step())));
  } else if (job->end() == RunJob::End::Done && !quiet) {
    const TriMesh* exportable = mesh(MeshKind::Exported).get();
    QString text = tr("Done up to %1").arg(stepTitle(job->until()));
    if (exportable && job->until() >= Step::Smooth) {
      text += tr(", %1 triangles, %2 s")
                  .arg(exportable->triangles.size())
                  .arg(meshRun_->totalSeconds, 0, 'f', 1);
    }
    say(Severity::Info, text + '.');
  }
  if (live) {
    Q_EMIT resultsChanged();
  }
  if (!quiet && !modified()) {
    cacheEvolve();
  }
  Q_EMIT statesChanged();
  if (load_) {
    return;
  }
  if (runAgain_) {
    run(*std::exchange(runAgain_, std::nullopt));
  } else if (pipeline_->key(job->until(), job->params()) != pipeline_->key(job->until(), params_)) {
    refreshFromCache();
  }
}

std::string CaseController::speedKey() const {
  std::string key = keys_[static_cast<std::size_t>(Step::Vesselness)];
  for (const char* name :
       {"levelset.xi", "levelset.b", "levelset.bRule", "levelset.bMin", "levelset.bMax"}) {
    const Field& field = findField(name);
    key += '/' + fieldText(field.get(params_), field);
  }
  return key;
}

void CaseController::requestSpeed() {
  if (speedRun_ || !shown_.vesselness) {
    return;
  }
  speedRun_ = std::make_shared<SpeedJob>();
  speedRun_->vesselness = shown_.vesselness;
  speedRun_->params = params_.levelset;
  speedRun_->key = speedKey();
  speedRunner_->start([job = speedRun_] { job->execute(); });
  if (speedRunner_->running()) {
    timer_.start();
  } else {
    finishSpeed();
  }
}

void CaseController::finishSpeed() {
  const std::shared_ptr<SpeedJob> job = std::exchange(speedRun_, nullptr);
  if (job->vesselness != shown_.vesselness) {
    return;
  }
  speed_ = job->speed;
  speedKey_ = job->key;
  if (!job->error.empty()) {
    say(Severity::Error, QString::fromStdString(job->error));
  }
}

}  // namespace angiomesh

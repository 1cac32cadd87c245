// SPDX-License-Identifier: BSD-3-Clause
#include <QFileInfo>
#include <utility>

#include "core/parameters/field.h"
#include "gui/model/case_controller.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

/// More would make the undo stack no better and the start slow.
constexpr std::size_t kMostRestored = 50;

QString inWords(const CaseSource& source) {
  return CaseController::tr("%1, %2")
      .arg(gridText(source.grid))
      .arg(source.files > 1 ? CaseController::tr("%1 series of %2 files")
                                  .arg(QString::fromStdString(source.format))
                                  .arg(source.files)
                            : QString::fromStdString(source.format));
}

}  // namespace

void CaseController::openCase(CaseRequest request) {
  if (!request.folder.empty() && request.folder == store_.folder()) {
    say(Severity::Info, tr("The case %1 is open already.").arg(name_));
    return;
  }
  startLoad(std::make_shared<OpenCaseJob>(std::move(request)));
}

void CaseController::giveSource(const QString& path) {
  if (!pending_) {
    return;
  }
  CaseRequest request = pending_->request();
  request.place = pending_->place();
  request.source = QFileInfo(path).absoluteFilePath().toStdString();
  pending_.reset();
  startLoad(std::make_shared<OpenCaseJob>(std::move(request)));
}

void CaseController::takeParametersOnly() {
  if (!pending_ || pending_->request().source.empty()) {
    return;
  }
  const auto job = std::make_shared<LoadJob>(pending_->request().source, "volume");
  job->startWith(pending_->document().params);
  pending_.reset();
  startLoad(job);
}

void CaseController::finishCase(const std::shared_ptr<const OpenCaseJob>& job) {
  for (const std::string& warning : job->warnings()) {
    say(Severity::Warning, QString::fromStdString(warning));
  }
  if (!job->pipeline()) {
    pending_ = job;
    if (job->difference().empty()) {
      Q_EMIT sourceMissing(inWords(job->document().source));
    } else {
      Q_EMIT sourceDiffers(QString::fromStdString(job->difference()));
    }
    return;
  }
  takeLoaded(*job);
  const bool recovery = job->request().place && job->request().place->recovery;
  if (recovery) {
    name_ = tr("restored");
  }
  params_ = job->document().params;
  store_.begin(job->document(), job->place());
  sayOpened(job->info());
  Q_EMIT caseChanged();
  Q_EMIT parametersChanged();
  Q_EMIT resultsChanged();
  if (!recovery) {
    Q_EMIT opened(QString::fromStdString(job->path().string()));
  }
  if (!job->sourcePath().empty()) {
    Q_EMIT sourceSeen(QString::fromStdString(job->sourcePath().string()));
  }
  Q_EMIT caseFound(job->document().view);
  refreshFromCache();
  foundSteps_ = job->steps();
  if (foundSteps_.empty()) {
    return;
  }
  if (job->request().restore) {
    restoreEdits();
  } else {
    Q_EMIT editsFound(static_cast<int>(foundSteps_.size()));
  }
}

void CaseController::restoreEdits() {
  const std::vector<JournalStep> steps = std::exchange(foundSteps_, {});
  if (steps.empty()) {
    return;
  }
  restoring_ = true;
  const std::size_t first = steps.size() > kMostRestored ? steps.size() - kMostRestored : 0;
  for (std::size_t i = first; i < steps.size(); ++i) {
    change(steps[i].params, QString::fromStdString(steps[i].text));
  }
  restoring_ = false;
  const std::size_t count = steps.size() - first;
  say(Severity::Info, count == 1 ? tr("Restored a change that had not been saved.")
                                 : tr("Restored %1 changes that had not been saved.").arg(count));
}

void CaseController::forgetEdits() {
  foundSteps_.clear();
  store_.forgetEdits();
  keepPolling();
}

CaseSource CaseController::describeSource() const {
  CaseSource source;
  source.hash = pipeline_->source().hash;
  source.format = info_.format;
  source.files = info_.files;
  source.grid = image()->geometry;
  return source;
}

void CaseController::saveCase(const QString& folder, const CaseView& view) {
  if (!pipeline_) {
    return;
  }
  store_.save(QFileInfo(folder).absoluteFilePath().toStdString(),
              {describeSource(), params_, view, 0});
  cacheEvolve();
  keepPolling();
  poll();
}

void CaseController::cacheEvolve() {
  const auto i = static_cast<std::size_t>(Step::Evolve);
  const bool fresh = shown_.evolve && shown_.evolve->stopReason != StopReason::Stopped &&
                     keys_[i] == pipeline_->key(Step::Evolve, params_);
  if (!fresh || (store_.folder().empty() && !store_.saving())) {
    return;
  }
  store_.cache({*shown_.evolve, shown_.stages[i]});
  keepPolling();
}

QString CaseController::caseFolder() const {
  return QString::fromStdString(store_.folder().string());
}

std::string CaseController::sourceHash() const {
  return pipeline_ ? pipeline_->source().hash : std::string();
}

void CaseController::leaveCase() {
  if (!store_.begun()) {
    return;
  }
  store_.leave();
  foundSteps_.clear();
  noteFailed_ = false;
  keepPolling();
}

void CaseController::noteEdit() {
  if (restoring_ || !store_.begun()) {
    return;
  }
  store_.note({0, undo_.index(), undo_.undoText().toStdString(), params_});
  keepPolling();
}

void CaseController::keepPolling() {
  // A timer that is started again with each move of a slider would never come to its end.
  if (!timer_.isActive()) {
    timer_.start();
  }
}

void CaseController::pollStore() {
  using Kind = CaseStore::Outcome::Kind;
  for (const CaseStore::Outcome& outcome : store_.poll()) {
    const std::string name = outcome.folder.stem().string();
    const QString reason = QString::fromStdString(withoutPath(outcome.error, outcome.folder, name));
    switch (outcome.kind) {
      case Kind::Saved:
        say(Severity::Info, tr("Saved the case %1.").arg(QString::fromStdString(name)));
        if (!outcome.present) {
          break;
        }
        name_ = QString::fromStdString(name);
        if (parametersToJson(outcome.document.params) == parametersToJson(params_)) {
          undo_.setClean();
        } else {
          undo_.resetClean();
        }
        Q_EMIT caseSaved(QString::fromStdString(outcome.folder.string()));
        break;
      case Kind::NotSaved:
        say(Severity::Error, tr("Cannot save the case: %1").arg(reason));
        Q_EMIT caseNotSaved();
        break;
      case Kind::NotNoted:
        if (!std::exchange(noteFailed_, true)) {
          say(Severity::Warning,
              tr("Edits are not kept for a restore, save the case elsewhere: %1").arg(reason));
        }
        break;
    }
  }
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/case_sensitivity.h"

#include <QLocale>
#include <algorithm>
#include <utility>

#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

/// Of the camera that goes to a branch.
constexpr double kLeastRadiusMm = 0.5;

QString shownNumber(const Field& field, double value) {
  return QLocale().toString(value * field.shownTimes, 'g', 4);
}

}  // namespace

CaseSensitivity::CaseSensitivity(CaseModels& models, const JobRunnerFactory& makeRunner,
                                 QObject* parent)
    : QObject(parent),
      models_(models),
      slot_(
          models.timer, makeRunner,
          [this](const std::shared_ptr<SensitivityJob>& job) { finish(*job); },
          [this](SensitivityJob&) { Q_EMIT progressed(); }) {
  connect(&models_.files, &CaseFiles::caseChanged, this, &CaseSensitivity::forget);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &CaseSensitivity::changed);
}

CaseSensitivity::~CaseSensitivity() { cancel(); }

QString CaseSensitivity::whyNot() const {
  if (!models_.document.hasCase()) return tr("Open a scan first.");
  if (isSegmented(models_.document.parameters()))
    return tr("The wall of a segmentation depends on no such parameter.");
  return {};
}

void CaseSensitivity::start() {
  if (slot_ || !whyNot().isEmpty()) return;
  auto job = std::make_shared<SensitivityJob>();
  job->source = models_.document.pipeline()->source();
  job->params = models_.document.parameters();
  triedKey_ = models_.document.key(Step::Correct);
  error_.clear();
  if (slot_.startAndPoll(std::move(job))) Q_EMIT changed();
}

void CaseSensitivity::cancel() {
  if (slot_) slot_.job()->progress.cancel();
}

double CaseSensitivity::fraction() const { return slot_ ? slot_.job()->progress.fraction() : 0.0; }

void CaseSensitivity::finish(const SensitivityJob& job) {
  if (!job.progress.cancelled()) {
    error_ = QString::fromStdString(job.error);
    if (job.drawn) {
      found_ = job.drawn;
      key_ = triedKey_;
      seconds_ = job.seconds;
      chosen_ = kAll;
    }
  }
  Q_EMIT changed();
}

void CaseSensitivity::forget() {
  cancel();
  found_.reset();
  error_.clear();
  chosen_ = kAll;
  Q_EMIT changed();
}

bool CaseSensitivity::stale() const {
  return found_ && models_.document.hasCase() && key_ != models_.document.key(Step::Correct);
}

void CaseSensitivity::choose(int effect) {
  if (std::exchange(chosen_, effect) != effect) Q_EMIT changed();
}

void CaseSensitivity::setPainted(bool on) {
  if (std::exchange(painted_, on) != on) Q_EMIT changed();
}

const std::vector<float>& CaseSensitivity::values() const {
  return chosen_ == kAll ? found_->spread : found_->moves[static_cast<std::size_t>(chosen_)];
}

std::array<double, 2> CaseSensitivity::scale() const {
  const double most = found_->scaleMm;
  return chosen_ == kAll ? std::array{most, 0.0} : std::array{-most, most};
}

QString CaseSensitivity::stepText(const ParameterStep& step) {
  const Field& field = findField(step.key);
  return tr("%1 %2 → %3")
      .arg(labelOf(field), shownNumber(field, step.from), shownNumber(field, step.to));
}

QString CaseSensitivity::title() const {
  return chosen_ == kAll
             ? tr("Largest move of the wall, mm")
             : tr("Move outwards, mm: %1")
                   .arg(stepText(found_->found.effects[static_cast<std::size_t>(chosen_)].step));
}

void CaseSensitivity::visit(int branch) {
  const SkeletonBranch& to =
      found_->found.places.skeleton.branches[static_cast<std::size_t>(branch)];
  const Eigen::Vector3d& middle = to.points[to.points.size() / 2].pointLps;
  Q_EMIT goTo(middle[0], middle[1], middle[2], std::max(to.meanRadiusMm, kLeastRadiusMm));
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/live_preview.h"

#include <utility>

namespace angiomesh {

LivePreview::LivePreview(CaseDocument& document, ResultModel& results, RunModel& runs,
                         JobTimer& timer, const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      document_(document),
      results_(results),
      runs_(runs),
      slot_(
          timer, makeRunner, [this](const std::shared_ptr<PreviewJob>& job) { finish(*job); },
          [this](PreviewJob& job) { watch(job); }) {
  connect(&document_, &CaseDocument::parametersChanged, this, &LivePreview::refresh);
  connect(&results_, &ResultModel::resultsChanged, this, &LivePreview::refresh);
  connect(&runs_, &RunModel::statesChanged, this, &LivePreview::refresh);
}

LivePreview::~LivePreview() {
  document_.disconnect(this);
  results_.disconnect(this);
  runs_.disconnect(this);
  if (slot_) slot_.job()->progress.cancel();
}

void LivePreview::setOn(bool on) {
  if (std::exchange(on_, on) == on) return;
  refresh();
  Q_EMIT changed();
}

void LivePreview::setWatched(bool watched) {
  if (std::exchange(watched_, watched) != watched) refresh();
}

void LivePreview::setFocus(const Eigen::Vector3d& lps) {
  focus_ = lps;
  refresh();
}

void LivePreview::setSide(int voxels) {
  side_ = voxels;
  refresh();
}

QString LivePreview::whyNot() const {
  const Parameters& params = document_.parameters();
  if (!document_.hasCase()) return tr("open a scan first");
  if (isSegmented(params) || params.segmentation.method != SegmentationMethod::LevelSet)
    return tr("level set only");
  if (runs_.running()) return tr("a run is on");
  if (!results_.vesselnessResult()) return tr("run once first");
  if (!results_.fresh(Step::Vesselness)) return tr("run anew first");
  if (results_.fresh(Step::Evolve)) return tr("move a slider below");
  return {};
}

QString LivePreview::status() const {
  if (!on_) return {};
  if (const QString why = whyNot(); !why.isEmpty()) return why;
  if (!error_.isEmpty()) return error_;
  return slot_ ? tr("evolving…") : tr("in %1 s").arg(seconds_, 0, 'f', 1);
}

VoxelBox LivePreview::box() const {
  return boxAround(results_.vesselnessResult()->multiScale->geometry, focus_,
                   {side_, side_, side_});
}

std::string LivePreview::keyNow() const {
  const VoxelBox around = box();
  std::string key = document_.key(Step::Evolve);
  for (const Index3& corner : {around.low, around.high})
    for (const int index : corner) key += " " + std::to_string(index);
  return key;
}

void LivePreview::refresh() {
  if (!on_ || !watched_ || !whyNot().isEmpty()) {
    forget();
    return;
  }
  if (slot_) {
    giveWay();
  } else if (keyNow() != shownKey_) {
    start();
  }
}

void LivePreview::start() {
  auto job = std::make_shared<PreviewJob>();
  const auto evolve = results_.evolveResult();
  job->ground = {results_.layer(Layer::Preprocessed), results_.vesselnessResult(),
                 document_.seeds(), evolve ? evolve->phi : nullptr};
  if (const auto seeds = results_.seedsResult())
    job->ground.seedsLps.insert(job->ground.seedsLps.end(), seeds->pointsLps.begin(),
                                seeds->pointsLps.end());
  if (!job->ground.image) return;
  job->params = document_.parameters();
  job->box = box();
  triedKey_ = keyNow();
  frontSeen_ = false;
  error_.clear();
  if (slot_.startAndPoll(std::move(job))) Q_EMIT changed();
}

void LivePreview::watch(PreviewJob& job) {
  const auto front = job.snapshots->take();
  if (!front || job.progress.cancelled()) return;
  phi_ = front->phi;
  shownKey_.clear();
  frontSeen_ = true;
  giveWay();
  Q_EMIT changed();
}

void LivePreview::finish(const PreviewJob& job) {
  // Also where it had ended by then, what nobody wants any more is not shown.
  if (job.phi && !job.progress.cancelled()) {
    phi_ = job.phi;
    shownKey_ = triedKey_;
    seconds_ = job.seconds;
  }
  // One that cannot be made is not asked for again before something changes.
  if (!job.error.empty()) {
    phi_.reset();
    shownKey_ = triedKey_;
    error_ = QString::fromStdString(job.error);
  }
  refresh();
  Q_EMIT changed();
}

/// A preview of what has changed since it began shows at least its front before the next one.
void LivePreview::giveWay() {
  if (frontSeen_ && keyNow() != triedKey_) slot_.job()->progress.cancel();
}

void LivePreview::forget() {
  if (slot_) slot_.job()->progress.cancel();
  const bool shown = phi_ != nullptr;
  phi_.reset();
  shownKey_.clear();
  error_.clear();
  if (shown) Q_EMIT changed();
}

}  // namespace angiomesh

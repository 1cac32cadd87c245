// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/case_review.h"

#include <algorithm>
#include <utility>

namespace angiomesh {

CaseReviewModel::CaseReviewModel(CaseModels& models, const JobRunnerFactory& makeRunner,
                                 QObject* parent)
    : QObject(parent),
      models_(models),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<DoubtJob>& job) { finish(*job); }) {
  connect(&models_.document, &CaseDocument::notesChanged, this, &CaseReviewModel::changed);
  connect(&models_.results, &ResultModel::resultsChanged, this, &CaseReviewModel::follow);
  connect(&models_.files, &CaseFiles::caseChanged, this, &CaseReviewModel::follow);
}

CaseReviewModel::~CaseReviewModel() {
  if (slot_) slot_.job()->progress.cancel();
}

std::shared_ptr<const Volume<float>> CaseReviewModel::shownPhi() const {
  return models_.results.segmentation() ? models_.results.uncutPhi() : nullptr;
}

std::string CaseReviewModel::shownKey() const { return models_.results.key(Step::Correct); }

bool CaseReviewModel::canReview() const { return shownPhi() && !models_.results.live(); }

bool CaseReviewModel::verdictStale() const {
  return !review().key.empty() && review().key != shownKey();
}

/// Another segmentation is shown: its places are not known.
void CaseReviewModel::follow() {
  if (slot_ && slot_.job()->phi != shownPhi()) slot_.job()->progress.cancel();
  if (foundIn_ && !found()) {
    places_.clear();
    foundIn_.reset();
    current_ = -1;
  }
  Q_EMIT changed();
}

void CaseReviewModel::change(const CaseReview& after, const QString& text,
                             const QString& mergeKey) {
  if (!models_.document.hasCase() || after == review()) return;
  CaseNotes notes = models_.document.notes();
  notes.review = after;
  models_.document.changeNotes(notes, text, mergeKey, !mergeKey.isEmpty());
}

void CaseReviewModel::setVerdict(Verdict verdict) {
  CaseReview after = review();
  after.verdict = verdict;
  after.key = shownKey();
  change(after, verdict == Verdict::Accepted   ? tr("accept the segmentation")
                : verdict == Verdict::Rejected ? tr("reject the segmentation")
                                               : tr("take the verdict back"));
}

void CaseReviewModel::setScore(int score) {
  CaseReview after = review();
  after.score = score;
  after.key = shownKey();
  change(after, tr("score the segmentation"));
}

void CaseReviewModel::addRemark(const Eigen::Vector3d& pointLps) {
  CaseReview after = review();
  after.remarks.push_back({pointLps, 0, {}});
  change(after, tr("add a remark"));
}

void CaseReviewModel::setRemark(int index, int score, const QString& text) {
  CaseReview after = review();
  if (index < 0 || index >= static_cast<int>(after.remarks.size())) return;
  ReviewRemark& remark = after.remarks[static_cast<std::size_t>(index)];
  remark.score = score;
  remark.text = text.toStdString();
  change(after, tr("edit a remark"));
}

void CaseReviewModel::removeRemark(int index) {
  CaseReview after = review();
  if (index < 0 || index >= static_cast<int>(after.remarks.size())) return;
  after.remarks.erase(after.remarks.begin() + index);
  change(after, tr("remove a remark"));
}

void CaseReviewModel::find() {
  if (slot_ || found() || !canReview()) return;
  auto job = std::make_shared<DoubtJob>();
  job->phi = shownPhi();
  job->vesselness = models_.results.vesselnessResult();
  job->thresholds = models_.results.segmentation()->thresholds;
  slot_.startAndPoll(std::move(job));
  Q_EMIT changed();
}

void CaseReviewModel::finish(const DoubtJob& job) {
  const int step = std::exchange(wantedStep_, 0);
  if (job.progress.cancelled() || job.phi != shownPhi()) {
    if (step != 0) this->step(step);
    Q_EMIT changed();
    return;
  }
  if (!job.error.empty()) models_.log.say(Severity::Error, job.error);
  places_ = job.places;
  foundIn_ = job.phi;
  current_ = -1;
  if (step != 0) this->step(step);
  Q_EMIT changed();
}

bool CaseReviewModel::seen(int place) const {
  const DoubtfulPlace& of = places_[static_cast<std::size_t>(place)];
  const double near = 2.0 * foundIn_->geometry.voxelMm();
  return std::any_of(review().seen.begin(), review().seen.end(), [&](const SeenPlace& one) {
    return one.kind == of.kind && (one.pointLps - of.pointLps).norm() < near;
  });
}

int CaseReviewModel::seenCount() const {
  int count = 0;
  for (int i = 0; i < static_cast<int>(places_.size()); ++i) count += seen(i) ? 1 : 0;
  return count;
}

void CaseReviewModel::visit(int place) {
  if (place < 0 || place >= static_cast<int>(places_.size())) return;
  current_ = place;
  const DoubtfulPlace& at = places_[static_cast<std::size_t>(place)];
  constexpr double kVoxelsAround = 6.0;
  Q_EMIT goTo(at.pointLps[0], at.pointLps[1], at.pointLps[2],
              kVoxelsAround * foundIn_->geometry.voxelMm());
  if (seen(place)) {
    Q_EMIT changed();
    return;
  }
  CaseReview after = review();
  after.seen.push_back({at.kind, at.pointLps});
  change(after, tr("look at doubtful places"), QStringLiteral("review.seen"));
}

void CaseReviewModel::step(int by) {
  if (!found()) {
    wantedStep_ = by;
    find();
    return;
  }
  const auto count = static_cast<int>(places_.size());
  if (count == 0) {
    models_.log.say(Severity::Info, tr("No place of this segmentation is doubtful."));
    return;
  }
  const int from = current_ < 0 && by < 0 ? 0 : current_;
  visit(((from + by) % count + count) % count);
}

}  // namespace angiomesh

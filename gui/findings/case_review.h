// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "gui/job/result_jobs.h"
#include "gui/model/case_models.h"

namespace angiomesh {

/// The review of the case: a verdict, scores, remarks, and the doubtful places of the segmentation
/// shown, of which the notes keep those that were looked at.
class CaseReviewModel : public QObject {
  Q_OBJECT

 public:
  CaseReviewModel(CaseModels& models, const JobRunnerFactory& makeRunner,
                  QObject* parent = nullptr);
  ~CaseReviewModel() override;

  [[nodiscard]] const CaseReview& review() const { return models_.document.notes().review; }
  /// There is a segmentation to be reviewed, and it is not being made anew.
  [[nodiscard]] bool canReview() const;
  /// Whether verdict and score were given to another segmentation than the one shown.
  [[nodiscard]] bool verdictStale() const;

  // Edits, each undoable.
  void setVerdict(Verdict verdict);
  void setScore(int score);
  void addRemark(const Eigen::Vector3d& pointLps);
  void setRemark(int index, int score, const QString& text);
  void removeRemark(int index);

  // Doubtful places.
  /// Looks for those of the segmentation shown, unless they are known; changed() tells when.
  void find();
  [[nodiscard]] bool finding() const { return static_cast<bool>(slot_); }
  /// Of the segmentation shown; none before find().
  [[nodiscard]] const std::vector<DoubtfulPlace>& places() const { return places_; }
  /// Whether they were looked for.
  [[nodiscard]] bool found() const { return foundIn_ && foundIn_ == shownPhi(); }
  [[nodiscard]] bool seen(int place) const;
  [[nodiscard]] int seenCount() const;
  /// Of the places; -1: none.
  [[nodiscard]] int current() const { return current_; }
  /// Goes to a place and marks it as seen.
  void visit(int place);
  /// To the next place or the one before, round the list; looks for them first if need be.
  void step(int by);

 Q_SIGNALS:
  void changed();
  void goTo(double x, double y, double z, double radiusMm);

 private:
  [[nodiscard]] std::shared_ptr<const Volume<float>> shownPhi() const;
  void change(const CaseReview& after, const QString& text, const QString& mergeKey = {});
  [[nodiscard]] std::string shownKey() const;
  void finish(const DoubtJob& job);
  void follow();

  CaseModels& models_;
  std::vector<DoubtfulPlace> places_;
  std::shared_ptr<const Volume<float>> foundIn_;
  int current_ = -1;
  int wantedStep_ = 0;  ///< once they are found
  JobSlot<DoubtJob> slot_;
};

}  // namespace angiomesh

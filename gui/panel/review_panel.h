// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace angiomesh {

class CaseReviewModel;
class ViewGrid;

/// The review of the case: verdict and score, remarks at places, and the list of doubtful places.
class ReviewPanel : public QWidget {
  Q_OBJECT

 public:
  ReviewPanel(CaseReviewModel& review, const ViewGrid& views, QWidget* parent = nullptr);

 private:
  void buildVerdict(QVBoxLayout* column);
  void buildRemarks(QVBoxLayout* column);
  void buildPlaces(QVBoxLayout* column);
  void refresh();
  void refreshVerdict();
  void refreshRemarks();
  void refreshPlaces();
  void remarkEdited(int row);

  CaseReviewModel& review_;
  const ViewGrid& views_;
  std::array<QPushButton*, 2> verdicts_{};  ///< accept, reject
  QComboBox* score_ = nullptr;
  QLabel* stale_ = nullptr;
  QTableWidget* remarks_ = nullptr;
  std::array<QPushButton*, 2> remarkButtons_{};
  QTableWidget* places_ = nullptr;
  QLabel* count_ = nullptr;
  std::array<QPushButton*, 3> placeButtons_{};
};

}  // namespace angiomesh

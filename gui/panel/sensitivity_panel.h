// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "gui/findings/case_sensitivity.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace angiomesh {

/// By how much the wall moves when a parameter does: a row for each step, and for each branch what
/// the chosen step does to its radius.
class SensitivityPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SensitivityPanel(CaseSensitivity& sensitivity, QWidget* parent = nullptr);

 private:
  void buildTables();
  void refresh();
  void fillSteps();
  void fillBranches();
  void showProgress();

  CaseSensitivity& sensitivity_;
  const DrawnSensitivity* filled_ = nullptr;  ///< what the tables are of
  int filledBranches_ = CaseSensitivity::kAll;
  QPushButton* start_;
  QPushButton* cancel_;
  QCheckBox* paint_;
  QProgressBar* progress_;
  QLabel* note_;
  QTableWidget* steps_ = nullptr;
  QTableWidget* branches_ = nullptr;
};

}  // namespace angiomesh

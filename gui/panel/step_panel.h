// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>
#include <vector>

#include "gui/model/case_models.h"

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace angiomesh {

class FieldEditor;

/// One step of the pipeline: its state, its few main fields, and the rest behind "More".
class StepPanel : public QFrame {
  Q_OBJECT

 public:
  StepPanel(CaseModels& models, Step step, QWidget* parent = nullptr);

  /// Puts a widget of the step's own below the main fields.
  void addExtra(QWidget* widget);

 private:
  void buildHeader(QVBoxLayout& column);
  void buildFields(QVBoxLayout& column);
  void showParameters();
  void showMore();
  void showState();
  void showProgress();

  CaseModels& models_;
  Step step_;
  QLabel* dot_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QToolButton* run_ = nullptr;
  QToolButton* more_ = nullptr;
  int changedBelow_ = 0;  ///< fields under more_ that are not as in the preset
  QVBoxLayout* extras_ = nullptr;
  QWidget* rest_ = nullptr;
  std::vector<FieldEditor*> editors_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace angiomesh {

struct CaseModels;

/// The steps of the pipeline, top to bottom, with the preset and the buttons that run them all.
class PipelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PipelinePanel(CaseModels& models, QWidget* parent = nullptr);

 private:
  QWidget* buildNotes();
  void refreshFailure();
  void refreshPreset();
  void refreshButtons();

  CaseModels& models_;
  QLabel* failure_ = nullptr;
  QComboBox* preset_;
  QPushButton* run_;
  QPushButton* cancel_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <QWidget>

#include "gui/model/live_preview.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace angiomesh {

struct CaseModels;

/// The steps of the pipeline, top to bottom, with the preset and the buttons that run them all.
class PipelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PipelinePanel(CaseModels& models, QWidget* parent = nullptr);

  /// What the button beside the presets opens.
  void setPresetMenu(QMenu* menu);

 protected:
  // While the panel is open, somebody tunes.
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildLive();
  QWidget* buildNotes();
  void refreshLive();
  void refreshFailure();
  void listPresets();
  void refreshPreset();
  void refreshButtons();

  CaseModels& models_;
  QLabel* failure_ = nullptr;
  QPointer<LivePreview> preview_;  ///< goes before the panel is hidden for good
  QCheckBox* live_ = nullptr;
  QSpinBox* liveSide_ = nullptr;
  QLabel* liveStatus_ = nullptr;
  QComboBox* preset_;
  QToolButton* presetMenu_;
  QPushButton* run_;
  QPushButton* cancel_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "gui/model/case_models.h"
#include "gui/model/view_state.h"

class QComboBox;
class QMainWindow;
class QMenu;
class QSlider;
class QToolBar;

namespace angiomesh {

/// What lies over the slices, and how their planes lie: a part of the menu View and of the tool bar
/// of the panes.
class PaneTools : public QObject {
  Q_OBJECT

 public:
  PaneTools(QMainWindow* window, CaseModels& models, ViewState& state);

  // Each is built once, the menu first.
  void addTo(QMenu* viewMenu);
  void addTo(QToolBar* bar);

  void refresh();

 private:
  void addPlanes(QMenu* menu);

  QMainWindow* window_;
  CaseModels& models_;
  ViewState& state_;
  QComboBox* overlay_ = nullptr;
  QSlider* opacity_ = nullptr;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "gui/model/case_models.h"
#include "gui/model/view_state.h"

class QMainWindow;
class QMenu;

namespace angiomesh {

/// How the image is seen in 3D: the menu "Volume in 3D", of View and of the 3D pane.
class VolumeMenu : public QObject {
  Q_OBJECT

 public:
  VolumeMenu(QMainWindow* window, QMenu* parent, CaseModels& models, ViewState& state);

 private:
  void refresh();

  QMainWindow* window_;
  CaseModels& models_;
  ViewState& state_;
};

}  // namespace angiomesh

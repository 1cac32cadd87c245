// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QComboBox>
#include <QWidget>

#include "gui/model/view_state.h"

class QToolButton;

namespace angiomesh {

class SurfaceView;

/// Of the two meshes that the 3D pane can show side by side.
enum class MeshPlace { Shown, Beside };

/// The list of meshes: which one is shown in a place. That from a file can be chosen where there is
/// one.
class MeshCombo : public QComboBox {
  Q_OBJECT

 public:
  MeshCombo(MeshPlace place, CaseModels& models, ViewState& state, QWidget* parent = nullptr);

 private:
  void refresh();

  MeshPlace place_;
  CaseModels& models_;
  ViewState& state_;
};

/// In the upper left corner of a 3D view, while there are meshes: which of them it shows. The
/// first view's splits the pane for two of them, the second one's links their cameras.
class MeshChooser : public QWidget {
  Q_OBJECT

 public:
  MeshChooser(MeshPlace place, CaseModels& models, ViewState& state, SurfaceView* view);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void place();

  MeshPlace place_;
  CaseModels& models_;
  ViewState& state_;
  MeshCombo* mesh_;
  QToolButton* button_;
};

}  // namespace angiomesh

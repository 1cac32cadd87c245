// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTableWidget>

#include "gui/model/view_state.h"

namespace angiomesh {

class MeshInspection;

/// The worst triangles of the mesh shown by the measure chosen. The row that is chosen takes the 3D
/// pane and the crosshair there.
class WorstList : public QTableWidget {
  Q_OBJECT

 public:
  WorstList(MeshInspection& inspection, CaseModels& models, ViewState& state,
            QWidget* parent = nullptr);

 private:
  void refresh();

  MeshInspection& inspection_;
  CaseModels& models_;
  ViewState& state_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QTabWidget;
class QVBoxLayout;

namespace angiomesh {

struct CaseModels;
class HistogramWidget;
class MeshFile;
class MeshInspection;
class QualityGrid;
class ViewState;

/// What the mesh is worth: which mesh the 3D pane shows and how it is coloured; our meshes beside
/// marching cubes in numbers; whether a solver or a printer would take it; how one measure is
/// spread over the triangles, and where it is worst.
class InspectorPanel : public QWidget {
  Q_OBJECT

 public:
  InspectorPanel(CaseModels& models, ViewState& state, MeshInspection& inspection,
                 const MeshFile& file, QWidget* parent = nullptr);

 Q_SIGNALS:
  void openMeshRequested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void addChoosers(QVBoxLayout* column);
  QWidget* gatesTab();
  QWidget* trianglesTab();
  void connectInspection();
  void refreshState();
  void refreshMeasured();
  void refreshHints();

  CaseModels& models_;
  ViewState& state_;
  MeshInspection& inspection_;
  const MeshFile& file_;
  QComboBox* colour_ = nullptr;
  QCheckBox* comparison_ = nullptr;
  QLabel* hints_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QualityGrid* grid_ = nullptr;
  QWidget* triangles_ = nullptr;
  HistogramWidget* histogram_ = nullptr;
  QLabel* bands_ = nullptr;
};

}  // namespace angiomesh

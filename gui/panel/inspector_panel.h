// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QTableWidget;

namespace angiomesh {

struct CaseModels;
class HistogramWidget;
class ViewState;

/// What the mesh is worth: our meshes beside marching cubes in numbers and histograms, whether a
/// solver would take it, which mesh the 3D pane shows and how it is coloured.
class InspectorPanel : public QWidget {
  Q_OBJECT

 public:
  InspectorPanel(CaseModels& models, ViewState& state, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void buildTable();
  void refreshResults();
  void refreshState();
  void refreshVerified();
  void refreshHints();

  CaseModels& models_;
  ViewState& state_;
  QComboBox* mesh_;
  QComboBox* colour_;
  QCheckBox* comparison_;
  QLabel* hints_ = nullptr;
  QTableWidget* table_ = nullptr;
  QWidget* plots_;
  HistogramWidget* angles_;
  HistogramWidget* ratios_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "gui/model/view_state.h"

class QGridLayout;

namespace angiomesh {

class SliceView;
class SurfaceView;
class VtkView;

/// The four panes: axial, sagittal, coronal and 3D, linked in crosshair, window, level and slab.
class ViewGrid : public QWidget {
  Q_OBJECT

 public:
  ViewGrid(CaseController& controller, ViewState& state, QWidget* parent = nullptr);

  [[nodiscard]] SliceView* slice(int plane) const {
    return slices_[static_cast<std::size_t>(plane)];
  }
  [[nodiscard]] SurfaceView* surface() const { return surface_; }

  /// Shows one pane alone, or all four again when it is alone already.
  void toggleMaximised(QWidget* pane);
  [[nodiscard]] bool maximised() const { return maximised_ != nullptr; }
  void resetViews();

 Q_SIGNALS:
  void hovered(const QString& text);

 private:
  void connectSlice(SliceView* view);
  void refreshAll();
  void refreshImage();
  void refreshSegmentation();
  void refreshSurface();
  void refreshEdits();

  CaseController& controller_;
  ViewState& state_;
  std::array<SliceView*, 3> slices_{};  ///< by plane: sagittal, coronal, axial
  SurfaceView* surface_ = nullptr;
  QWidget* maximised_ = nullptr;
  std::shared_ptr<const Volume<float>> shownImage_, shownPhi_;
  std::shared_ptr<const TriMesh> shownMesh_;
  std::shared_ptr<const MeshFacts> shownFacts_;
  MeshColour shownColour_ = MeshColour::Plain;
};

}  // namespace angiomesh

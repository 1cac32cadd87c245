// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gui/model/result_text.h"
#include "gui/model/view_state.h"
#include "render/marks/measure_mark.h"
#include "render/marks/port_mark.h"
#include "render/slice/slice_pixels.h"

namespace angiomesh {

class CasePorts;
class CaseSensitivity;
class MeshInspection;
class SliceView;
class SurfaceFeed;
class SurfacePane;
class VolumeFeed;
class SurfaceView;
class VtkView;

/// Four: two by two. OneAndThree: a large one and the others in a column at its right. Single: the
/// large one alone.
enum class PaneLayout { Four, OneAndThree, Single };

/// The four panes: axial, sagittal, coronal and 3D, linked in crosshair, window and
/// level.
class ViewGrid : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kNoSlice = -1;

  ViewGrid(CaseModels& models, ViewState& state, CasePorts& ports, MeshInspection& inspection,
           CaseSensitivity& sensitivity, const JobRunnerFactory& makeRunner,
           QWidget* parent = nullptr);

  [[nodiscard]] SliceView* slice(int plane) const {
    return slices_[static_cast<std::size_t>(plane)];
  }
  [[nodiscard]] SurfaceView* surface() const { return surface_; }
  /// Shows the surface in 3D, with parts left out of it.
  [[nodiscard]] SurfaceFeed* surfaceFeed() const;
  /// Beside it: another mesh (ViewState::comparison()) or the projection of the result
  /// (ViewState::resultBeside()); hidden without them.
  [[nodiscard]] SurfaceView* comparison() const { return comparison_; }

  [[nodiscard]] PaneLayout paneLayout() const { return layout_; }
  /// The layout that follows when a single pane is toggled.
  [[nodiscard]] PaneLayout layoutOfAll() const { return layoutOfAll_; }
  /// The pane that is large or alone: the last one that was. The 3D pane goes by its surface view.
  [[nodiscard]] QWidget* largePane() const;
  void setLargePane(QWidget* pane);
  void setPaneLayout(PaneLayout layout);
  /// Shows one pane alone, or all four again when it is alone already.
  void toggleMaximised(QWidget* pane);
  [[nodiscard]] bool maximised() const { return layout_ == PaneLayout::Single; }
  void resetViews();

  /// The panes that can be seen, from the upper left on.
  [[nodiscard]] std::vector<VtkView*> shown() const;
  /// The 3D pane; null while another one is alone.
  [[nodiscard]] VtkView* shown3d() const;
  /// What the user calls a pane.
  [[nodiscard]] QString titleOf(const VtkView* pane) const;
  /// Of a pane; null: of any of them.
  [[nodiscard]] bool hasCrosshair(const VtkView* pane) const;
  /// What a pane shows (null: what all of them show, as they lie) on `scale` times its device
  /// pixels. @throws IoError
  [[nodiscard]] QImage picture(VtkView* pane, int scale, bool crosshair) const;
  [[nodiscard]] QSize pictureSize(const VtkView* pane, int scale) const;

  /// Of all slice panes, mm LPS.
  [[nodiscard]] Eigen::Vector3d crosshair() const;
  /// Takes the panes to a place, and the camera near a vessel of this radius; 0: it stays.
  void goTo(double x, double y, double z, double radiusMm);
  void setCrosshair(const Eigen::Vector3d& lps);

 Q_SIGNALS:
  void arranged();  ///< the layout or the large pane has changed
  void hovered(const QString& text);
  void crosshairMoved();
  /// A right click: `place` is empty where there is nothing, `port` off the ports. `plane` is
  /// kNoSlice in 3D.
  void menuRequested(const QPoint& global, const std::optional<Eigen::Vector3d>& place,
                     const QString& port, int plane);

 private:
  [[nodiscard]] int planeOf(const VtkView* view) const;
  void arrange();
  void connectSlice(SliceView* view);
  void refreshAll();
  void refreshImage();
  void showSlices3d();
  [[nodiscard]] ColourLayer overlayLayer() const;
  void refreshSegmentation();
  void showPreview();
  void refreshCaptions();
  void connectInspection();
  void refreshEdits();
  void refreshSeeds();
  void connectPorts();
  void refreshPorts();
  void showPorts();

  CaseModels& models_;
  ViewState& state_;
  CasePorts& ports_;
  MeshInspection& inspection_;
  std::array<SliceView*, 3> slices_{};  ///< by plane: sagittal, coronal, axial
  SurfacePane* pane3d_ = nullptr;       ///< holds the two 3D views
  SurfaceView* surface_ = nullptr;
  SurfaceView* comparison_ = nullptr;
  QWidget* large_ = nullptr;
  PaneLayout layout_ = PaneLayout::Four;
  PaneLayout layoutOfAll_ = PaneLayout::Four;
  std::shared_ptr<const Volume<float>> shownImage_, shownPhi_;
  bool layerShown_ = false;  ///< shownImage_ is the layer chosen, not the source in its place
  bool phiDimmed_ = false;
  VolumeFeed* imageFeed_ = nullptr;  ///< of the 3D pane
  std::vector<PortMark> shownPorts_;
  std::optional<MarkPoint> draggedSeed_;
};

}  // namespace angiomesh

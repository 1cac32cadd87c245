// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/quality/triangle_measures.h"
#include "gui/model/case_models.h"
#include "gui/model/mouse_tool.h"
#include "gui/model/window_presets.h"
#include "render/slice/pane_grid.h"
#include "render/slice/slice_raster.h"
#include "render/surface/volume_look.h"

namespace angiomesh {

constexpr double kThickestSlabMm = 200.0;

/// What the panes show and how: the one place that toolbar, menus, inspector and panes agree on.
/// Every setter that changes something emits changed().
class ViewState : public QObject {
  Q_OBJECT

 public:
  explicit ViewState(CaseModels& models, QObject* parent = nullptr);

  [[nodiscard]] Layer layer() const { return layer_; }
  void setLayer(Layer layer);

  /// Of the layer shown; each layer remembers its own, and keeps it within its limits. The source's
  /// last one is remembered for other images of its modality.
  [[nodiscard]] WindowLevel windowLevel() const;
  [[nodiscard]] WindowLimits windowLimits() const { return limitsOf(layer_); }
  void setWindowLevel(double window, double level);
  /// To what the layer begins with; what was remembered is forgotten.
  void resetWindowLevel();
  /// Of the layer shown; nothing: it does not suit it.
  [[nodiscard]] std::optional<WindowLevel> presetWindow(WindowPreset preset) const;
  void setPresetWindow(WindowPreset preset);
  /// The windows of the file beside WindowPreset::File, where they suit the layer.
  [[nodiscard]] std::vector<std::pair<WindowLevel, std::string>> otherFileWindows() const;

  /// Of a slice pane: 0 sagittal, 1 coronal, 2 axial.
  [[nodiscard]] const Slab& slab(int plane) const {
    return slabs_[static_cast<std::size_t>(plane)];
  }
  void setSlab(int plane, const Slab& slab) { set(slabs_[static_cast<std::size_t>(plane)], slab); }
  /// The same in all slice panes.
  void setSlabs(const Slab& slab) { set(slabs_, {slab, slab, slab}); }

  /// How the planes of the slice panes lie.
  [[nodiscard]] const PlaneTurn& turn() const { return turn_; }
  void setTurn(const PlaneTurn& turn) { set(turn_, turn); }
  void setPatientAxes(bool on);  ///< from there on the planes are not turned
  void resetTurn() { setPatientAxes(turn_.patientAxes); }

  /// A layer in colour over the one shown: Vesselness or Speed; nothing: none.
  [[nodiscard]] std::optional<Layer> overlay() const { return overlay_; }
  void setOverlay(std::optional<Layer> layer) { set(overlay_, layer); }
  [[nodiscard]] double overlayOpacity() const { return overlayOpacity_; }  ///< 0..1
  void setOverlayOpacity(double opacity) { set(overlayOpacity_, opacity); }
  /// The values that the colours go from and to: those of the layer's window.
  [[nodiscard]] std::array<double, 2> overlayRange() const;

  [[nodiscard]] bool contours() const { return contours_; }
  void setContours(bool on) { set(contours_, on); }
  /// How the image is seen in 3D: not Inside.
  [[nodiscard]] VolumeView volumeView() const { return volumeView_; }
  void setVolumeView(VolumeView view) { set(volumeView_, view); }
  /// The same, as it suits the layer shown: CtAngio suits the HU of a CT alone.
  [[nodiscard]] VolumeView volumeShown() const;
  [[nodiscard]] bool suitsCt() const;
  /// The projection of the result in a second 3D pane, seen by the same camera, beside that of the
  /// image, which then stands without the surface.
  [[nodiscard]] bool resultBeside() const { return resultBeside_; }
  void setResultBeside(bool on);
  [[nodiscard]] bool surface() const { return surface_; }
  void setSurface(bool on) { set(surface_, on); }
  /// Of the panes, in 3D.
  [[nodiscard]] bool slices3d() const { return slices3d_; }
  void setSlices3d(bool on) { set(slices3d_, on); }
  [[nodiscard]] bool edges() const { return edges_; }
  void setEdges(bool on) { set(edges_, on); }

  /// Of slices, between voxels. What the user chose is remembered.
  [[nodiscard]] bool interpolated() const { return interpolated_; }
  void setInterpolated(bool on);

  /// For a case file, without the crosshair; and back. A layer that is not there yet is shown once
  /// it is.
  [[nodiscard]] CaseView caseView() const;
  void take(const CaseView& view);

  [[nodiscard]] Tool tool() const { return tool_; }
  void setTool(Tool tool) { set(tool_, tool); }
  [[nodiscard]] MouseScheme scheme() const { return scheme_; }
  void setScheme(MouseScheme scheme) { set(scheme_, scheme); }

  [[nodiscard]] MeshKind meshKind() const { return meshKind_; }
  void setMeshKind(MeshKind kind) { set(meshKind_, kind); }
  /// Of triangleMeasures(): the measure that the surface is coloured by; null: none.
  [[nodiscard]] const TriangleMeasure* meshColour() const { return meshColour_; }
  void setMeshColour(const TriangleMeasure* measure) { set(meshColour_, measure); }
  /// Another mesh in a second 3D view beside the one shown.
  [[nodiscard]] bool comparison() const { return comparison_; }
  void setComparison(bool on);
  [[nodiscard]] MeshKind besideKind() const { return besideKind_; }
  void setBesideKind(MeshKind kind) { set(besideKind_, kind); }
  /// Whether the two have one camera.
  [[nodiscard]] bool linked() const { return linked_; }
  void setLinked(bool on) { set(linked_, on); }

 Q_SIGNALS:
  void changed();

 private:
  template <class T>
  void set(T& member, const std::type_identity_t<T>& value) {
    if (member != value) {
      member = value;
      Q_EMIT changed();
    }
  }

  void showAwaitedLayer();
  [[nodiscard]] WindowLimits limitsOf(Layer layer) const;
  void showWindow(const WindowLevel& window);

  CaseModels& models_;
  Layer layer_ = Layer::Source;
  std::optional<Layer> awaitedLayer_;
  std::array<WindowLevel, kLayerCount> windowLevels_;
  std::array<Slab, 3> slabs_;
  PlaneTurn turn_;
  std::optional<Layer> overlay_;
  double overlayOpacity_ = 0.5;
  VolumeView volumeView_ = VolumeView::Mip;
  bool contours_ = true, surface_ = true, edges_ = false;
  bool slices3d_ = false;
  bool interpolated_ = true;
  Tool tool_ = Tool::Navigate;
  MouseScheme scheme_ = MouseScheme::Radiology;
  MeshKind meshKind_ = MeshKind::Exported;
  const TriangleMeasure* meshColour_ = nullptr;
  bool comparison_ = false, resultBeside_ = false;
  MeshKind besideKind_ = MeshKind::MarchingCubes;
  bool linked_ = true;
};

}  // namespace angiomesh

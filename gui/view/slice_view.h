// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/image/volume.h"
#include "gui/model/mouse_tool.h"
#include "gui/model/window_presets.h"
#include "gui/view/vtk_view.h"
#include "render/marks/measure_mark.h"
#include "render/slice/slice_scene.h"

namespace angiomesh {

/// One slice pane. Positions are mm LPS. Middle button pans, right zooms, the wheel steps slices
/// (Ctrl: zooms, Alt: slab thickness), M goes through the kinds of slab, Shift with the moving
/// mouse sets the crosshair, a double click asks to maximise, arrow keys step slices (Shift: by
/// 10), R resets the view; Ctrl with the left drag changes window and level in fine steps; a left
/// click sets the crosshair; a click of the right button asks for a menu. The left button drags the
/// disc of a port along its vessel (Shift: within the slice), and the crosshair goes with it; by
/// the tip of its arrow it is turned in the slice. By a knob of the crosshair it turns the planes
/// of the other two panes.
class SliceView : public VtkView {
  Q_OBJECT

 public:
  explicit SliceView(QWidget* parent = nullptr);
  ~SliceView() override;

  /// Null shows nothing. Another image of the same geometry keeps slice, zoom and crosshair.
  void setImage(std::shared_ptr<const Volume<float>> image);
  void setPlane(int plane);  ///< 0 sagittal, 1 coronal, 2 axial
  void setWindowLevel(double window, double level);
  /// Where a drag of window and level ends, and how fast it goes.
  void setWindowLimits(const WindowLimits& limits);
  [[nodiscard]] double windowWidth() const;
  [[nodiscard]] double windowLevel() const;
  /// Moves the crosshair, and to the slice that it lies in. Emits no cursorMoved().
  void setCursor(const Eigen::Vector3d& lps);
  [[nodiscard]] Eigen::Vector3d cursor() const;
  void setCrosshairVisible(bool visible);
  void setInterpolated(bool on);  ///< between voxels
  void setSlab(const Slab& slab);
  [[nodiscard]] const Slab& slab() const;
  /// The zero level set to outline; it may live on another grid. Null removes it.
  void setContour(std::shared_ptr<const Volume<float>> phi, bool dimmed = false);
  /// The segmentation that is tried in a part of the volume; null: none.
  void setPreview(std::shared_ptr<const Volume<float>> phi);
  /// What the pane shows, in lines.
  void setCaption(const QString& lines);
  /// What the values under the pointer are of, and their unit; either may be empty.
  void setValueNames(const QString& layer, const QString& unit);
  /// Over the image; `name`: of its values under the pointer.
  void setColourLayer(const ColourLayer& layer, const QString& name);
  /// How the planes of all panes lie.
  void setTurn(const PlaneTurn& turn);
  /// Of the crosshair's arms, as last drawn, Qt's pixels.
  [[nodiscard]] std::vector<QPointF> knobs() const;
  [[nodiscard]] const SliceScene& scene() const;
  void setSeeds(std::vector<Eigen::Vector3d> byHand, std::vector<Eigen::Vector3d> found = {});
  void setRoi(std::optional<RoiBox> roi);
  void setPorts(std::vector<PortMark> marks);
  void setMeasures(std::vector<MeasureMark> marks);
  /// What is drawn of a correction while it is made.
  void setSketch(std::vector<MeasureMark> marks);
  void setTool(Tool tool);
  void setScheme(MouseScheme scheme);
  void resetView();

  [[nodiscard]] int slice() const;
  [[nodiscard]] int sliceCount() const;
  /// Clamped. Takes the crosshair along: emits cursorMoved() too.
  void setSlice(int slice);

  /// Widget position (Qt's pixels) -> mm LPS on the slice, and back.
  [[nodiscard]] Eigen::Vector3d lpsAt(const QPointF& position) const;
  [[nodiscard]] QPointF positionOf(const Eigen::Vector3d& lps) const;

 Q_SIGNALS:
  /// The crosshair was moved in this pane, or its slice changed under it; not by setCursor().
  void cursorMoved(double x, double y, double z);
  void windowLevelChanged(double window, double level);  ///< by the user
  void sliceChanged(int slice);                          ///< for whatever reason
  void slabChanged(const Slab& slab);                    ///< by the user
  void turnChanged(const PlaneTurn& turn);               ///< by the user; to be set in all panes
  void seedPicked(double x, double y, double z);
  void cutPicked(double x, double y, double z);
  void measurePicked(double x, double y, double z);
  void correctPicked(double x, double y, double z);
  /// A line is being painted, and is painted, mm LPS; a click paints one place.
  void strokeMoved(const std::vector<Eigen::Vector3d>& lineLps);
  void strokeDrawn(const std::vector<Eigen::Vector3d>& lineLps);
  /// The point of a measurement or, without a name, a seed is taken, dragged over the slice, and
  /// left where it was last.
  void markPressed(const QString& name);
  void markDragged(const MarkPoint& point);
  void markDropped();
  /// `port` is empty off the ports.
  void menuRequested(const QPoint& global, const std::optional<Eigen::Vector3d>& place,
                     const QString& port);
  void portPressed(const QString& name);
  void portDragged(const QString& name, const CutPlane& plane);
  void portDropped();
  void roiDrawn(const RoiBox& roi);
  /// "Source 40 HU, voxel i,j,k, L 12.3 P 4.1 S 30.0 mm", as the pane says too; empty outside the
  /// image.
  void hovered(const QString& text);
  /// The mouse is over a place of the slice, with no button down; mm LPS.
  void pointedAt(double x, double y, double z);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void pixelRatioChanged(double ratio) override;
  /// Without what is under the pointer, which comes back as the mouse moves on.
  void pictureBegins() override;

 private:
  void showContours();
  void moveCrosshair(const QPointF& position);
  void stepSlices(int towardsHead);
  void stepSlab(int steps);
  void chooseSlab(const Slab& slab);
  void dragContrast(const QPointF& moved, bool fine);
  /// What is under the pressed position, as the pane shows it; nothing outside the image.
  [[nodiscard]] std::optional<Eigen::Vector3d> picked() const;
  void hover();
  void dragPort(const QPointF& position, bool free);
  void showPointer(const QPointF& position);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace angiomesh

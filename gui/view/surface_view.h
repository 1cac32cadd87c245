// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "gui/view/slice_view.h"
#include "gui/view/vtk_view.h"
#include "render/marks/port_mark.h"
#include "render/slice/slice_scene.h"
#include "render/surface/surface_actor.h"
#include "render/surface/volume_look.h"

namespace angiomesh {

/// What software draws in a 25th of a second.
constexpr std::size_t kCoarseTriangles = 60000;

/// The 3D pane: left button turns, middle pans, right and wheel zoom, a double click asks to
/// maximise, keys A, P, L, S, I and Shift-R look from that side of the patient, as do the buttons
/// in the corner, arrow keys turn by 6 degrees, R resets. The left button drags the disc of a port
/// along its vessel (Shift: anywhere) and tilts it by its arrow; a left click on the surface points
/// at a place, a click of the right button asks for a menu.
class SurfaceView : public VtkView {
  Q_OBJECT

 public:
  explicit SurfaceView(QWidget* parent = nullptr);
  ~SurfaceView() override;

  void setImage(std::shared_ptr<const Volume<float>> image);
  /// The same, made ready by another thread.
  void setDrawnImage(std::shared_ptr<const DrawnVolume> image);
  void setVolumeView(VolumeView view);

  /// Replacing the surface keeps the camera. Null removes it.
  void setSurface(std::shared_ptr<const TriMesh> mesh);
  /// The same, made ready by another thread with kCoarseTriangles. No other view may show it.
  void setDrawnSurface(std::shared_ptr<const DrawnMesh> mesh);
  /// While something else needs the processor all frames are quick ones.
  void setBusy(bool busy);
  /// The slices of other panes where they lie; none hides them.
  void setSlices(const std::vector<const SliceView*>& views);
  /// What the menu that is asked for was asked on: a triangle of the surface.
  [[nodiscard]] std::optional<std::size_t> clickedTriangle() const;
  void setSurfaceVisible(bool visible);
  void setEdgesVisible(bool visible);
  /// What the pane shows, in lines; dimmed: the surface is out of date.
  void setCaption(const QString& lines, bool dimmed = false);

  /// One scalar per triangle, red at `lo`, blue at `hi`, which may be less, with a colour bar.
  void setSurfaceColours(std::vector<float> perTriangle, const QString& title, double lo,
                         double hi);
  void clearSurfaceColours();
  /// Triangles of the surface that stand out.
  void setMarked(const std::vector<std::uint32_t>& triangles);

  /// Of the patches 1.. of the surface.
  void setPatchColours(std::vector<std::array<double, 3>> colours);
  void setPorts(std::vector<PortMark> marks);
  void setMeasures(const std::vector<MeasureMark>& marks);
  /// Tool::CutVessel, those that measure and those that correct: a left click on the surface picks
  /// a place for them.
  void setTool(Tool tool) { tool_ = tool; }

  /// Qt's pixels of a point, and of the tip of a port's arrow.
  [[nodiscard]] QPointF positionOf(const Eigen::Vector3d& lps) const;
  [[nodiscard]] QPointF arrowTipOf(const QString& port) const;

  void setSeeds(std::vector<Eigen::Vector3d> lps);
  void setRoi(std::optional<RoiBox> roi);

  void viewFrom(char side);  ///< 'A', 'P', 'L', 'R', 'S', 'I'
  /// Turns what is seen, degrees: to the right about the pane's upward axis, and upwards.
  void turn(double right, double up);
  void lookAt(const Eigen::Vector3d& lps, double radiusMm);
  /// The same from the side of `normal`, unless that is 0.
  void lookAtFrom(const Eigen::Vector3d& lps, const Eigen::Vector3d& normal, double radiusMm);
  void resetView();  ///< from anterior (from the feet when the image lies flat), fitted
  /// Takes over the camera of another view. Two views that do so on each other's cameraMoved()
  /// show their surfaces side by side.
  void takeCameraOf(const SurfaceView& other);
  /// Not fitted to the pane's size any more, until the view is reset.
  void keepCamera();
  /// picture(), once all is turned about the vertical through the middle of the view.
  [[nodiscard]] QImage pictureTurned(double degrees, int scale, const QSize& size);

 Q_SIGNALS:
  void portPressed(const QString& name);
  void portDragged(const QString& name, const CutPlane& plane);
  void portDropped();
  void placePicked(double x, double y, double z);  ///< on the surface, with Tool::Navigate
  void cutPicked(double x, double y, double z);
  void measurePicked(double x, double y, double z);
  void correctPicked(double x, double y, double z);
  /// `place` is empty off the surface, `port` off the ports.
  void menuRequested(const QPoint& global, const std::optional<Eigen::Vector3d>& place,
                     const QString& port);
  /// By the user, viewFrom(), lookAt(), resetView() or a fit to the pane's size; not by
  /// takeCameraOf().
  void cameraMoved();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void pixelRatioChanged(double ratio) override;
  void pictureBegins() override;
  void paintGL() override;

 private:
  void changed();
  bool grabPort(const QPointF& position);
  void dragPort(const QPointF& position, bool free);
  void clicked(const QMouseEvent& event);
  void showGrip(const QPointF& position);

  struct State;
  std::unique_ptr<State> state_;
  Tool tool_ = Tool::Navigate;
};

}  // namespace angiomesh

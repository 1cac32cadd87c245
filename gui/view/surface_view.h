// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/image/volume.h"
#include "core/surface/tri_mesh.h"
#include "gui/view/vtk_view.h"
#include "render/slice_scene.h"

namespace angiomesh {

/// The 3D pane: left button turns, middle pans, right and wheel zoom, a double click asks to
/// maximise, keys A, P, L, S, I and Shift-R look from that side of the patient, R resets.
class SurfaceView : public VtkView {
  Q_OBJECT

 public:
  explicit SurfaceView(QWidget* parent = nullptr);
  ~SurfaceView() override;

  void setImage(std::shared_ptr<const Volume<float>> image);
  void setMipVisible(bool visible);
  /// Values shown from transparent up to white. setImage() proposes them from the image.
  void setMipWindow(double from, double to);

  /// Replacing the surface keeps the camera. Null removes it.
  void setSurface(std::shared_ptr<const TriMesh> mesh);
  /// A second surface (marching cubes), shown in another colour.
  void setComparison(std::shared_ptr<const TriMesh> mesh);
  void setSurfaceVisible(bool visible);
  void setComparisonVisible(bool visible);
  void setEdgesVisible(bool visible);

  /// One scalar per triangle, red at `lo`, blue at `hi`, with a colour bar.
  void setSurfaceColours(std::vector<float> perTriangle, const QString& title, double lo,
                         double hi);
  void setComparisonColours(std::vector<float> perTriangle);
  void clearSurfaceColours();

  void setSeeds(std::vector<Eigen::Vector3d> lps);
  void setRoi(std::optional<RoiBox> roi);

  void viewFrom(char side);  ///< 'A', 'P', 'L', 'R', 'S', 'I'
  void lookAt(const Eigen::Vector3d& lps, double radiusMm);
  void resetView();  ///< from anterior (from the feet when the image lies flat), fitted
  /// Takes over the camera of another view. Two views that do so on each other's cameraMoved()
  /// show their surfaces side by side.
  void takeCameraOf(const SurfaceView& other);

 Q_SIGNALS:
  void cameraMoved();  ///< by the user, viewFrom(), lookAt() or resetView(); not by takeCameraOf()

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void pixelRatioChanged(double ratio) override;

 private:
  void changed();

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace angiomesh

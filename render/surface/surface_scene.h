// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "render/marks/measure_mark.h"
#include "render/marks/port_marks.h"
#include "render/marks/surface_pick.h"
#include "render/slice/slice_scene.h"
#include "render/surface/surface_actor.h"
#include "render/surface/volume_look.h"

class vtkRenderer;
class vtkRenderWindow;

namespace angiomesh {

/// The 3D pane, in patient space (LPS, mm): the image as a projection or as a lit volume, the
/// surface, seeds, region of interest, and a small cube that names the directions.
class SurfaceScene {
 public:
  SurfaceScene();
  ~SurfaceScene();
  SurfaceScene(const SurfaceScene&) = delete;
  SurfaceScene& operator=(const SurfaceScene&) = delete;

  /// Adds the scene's renderers to a window, which must outlive the scene or be detached from it.
  void attach(vtkRenderWindow* window);
  void detach();
  [[nodiscard]] vtkRenderer* renderer() const;

  /// The first image resets the view; a later one of the same geometry keeps it.
  void setImage(std::shared_ptr<const Volume<float>> image);
  /// The same, made ready by another thread.
  void setDrawnImage(std::shared_ptr<const DrawnVolume> image);
  /// How the image is seen; at first its projection.
  void setVolumeView(VolumeView view);
  /// Values from which and up to which the projection goes from transparent to white, until the
  /// next image.
  void setMipWindow(double from, double to);
  /// Coarser sampling while the camera moves or surfaces arrive; full quality when false.
  void setInteractive(bool interactive);

  /// Replacing a surface never moves the camera (the very first thing shown does).
  void setSurface(std::shared_ptr<const TriMesh> mesh);
  /// The same, made ready by another thread. No other scene may draw it.
  void setDrawnSurface(std::shared_ptr<const DrawnMesh> mesh);
  /// A large surface by fewer triangles where OpenGL runs in software; setInteractive() does so,
  /// too.
  void setSurfaceCoarse(bool coarse);
  /// The slices of other panes where they lie. @returns whether anything has changed
  bool setSlices(const std::vector<const SliceScene*>& scenes);
  void setSurfaceVisible(bool visible);
  void setEdgesVisible(bool visible);
  /// As what is out of date.
  void setSurfaceDimmed(bool dimmed);
  /// Lines in the upper right corner, on what the pane shows.
  void setCaption(const std::string& lines);

  /// One scalar per triangle of the surface, shown from red (lo) over yellow to blue (hi), which
  /// may be less than lo, with a colour bar. Dropped when a surface with another number of
  /// triangles comes.
  void setSurfaceColours(std::vector<float> perTriangle, const std::string& title, double lo,
                         double hi);
  void clearSurfaceColours();
  /// Some triangles of the surface stand out, whatever its colours, and however small they are.
  void setMarked(const std::vector<std::uint32_t>& triangles);

  /// Of the patches 1.. of the surface, shown where it has no other colours.
  void setPatchColours(std::vector<std::array<double, 3>> colours);
  void setPorts(std::vector<PortMark> marks);
  void setMeasures(const std::vector<MeasureMark>& marks);
  [[nodiscard]] const std::vector<PortMark>& ports() const;

  /// Display positions are pixels of the window from the lower left corner.
  [[nodiscard]] ViewRay rayAt(double displayX, double displayY) const;
  /// Where the visible surface lies under a display position.
  [[nodiscard]] std::optional<Eigen::Vector3d> surfaceAt(double displayX, double displayY) const;
  /// The same with the triangle, of the whole mesh.
  [[nodiscard]] std::optional<SurfaceHit> hitAt(double displayX, double displayY) const;
  /// The movable port under a display position, unless the surface hides it.
  [[nodiscard]] std::optional<PortHit> portAt(double displayX, double displayY) const;
  /// The same whatever hides it, and fast.
  [[nodiscard]] std::optional<PortHit> gripAt(double displayX, double displayY) const;
  [[nodiscard]] PortDrag grabPort(const PortHit& hit, double displayX, double displayY) const;
  /// Display position of a point.
  [[nodiscard]] Eigen::Vector2d displayAt(const Eigen::Vector3d& lps) const;
  /// Of the arrow's tip of a port, mm LPS.
  [[nodiscard]] Eigen::Vector3d arrowTip(std::size_t port) const;

  void setSeeds(std::vector<Eigen::Vector3d> lps);
  void setRoi(const std::optional<RoiBox>& roi);

  /// Looks from the patient's 'A'nterior, 'P'osterior, 'L'eft, 'R'ight, 'S'uperior or 'I'nferior
  /// side, fitted; other letters change nothing.
  void viewFrom(char side);
  /// From anterior, fitted; from the feet when what there is lies flat in axial planes.
  void resetView();
  void fit();  ///< keeps the direction of view
  /// Turns what is seen, degrees: its front to the right, and upwards.
  void turn(double right, double up);
  /// Turns the camera towards a point, at a distance that shows `radiusMm` around it.
  void lookAt(const Eigen::Vector3d& lps, double radiusMm);
  /// The same from the side of `normal`; where that is 0, from where the camera is.
  void lookAtFrom(const Eigen::Vector3d& lps, const Eigen::Vector3d& normal, double radiusMm);
  void takeCameraOf(const SurfaceScene& other);
  void keepCamera();  ///< not fitted to another size, until it is fitted again
  void setPixelRatio(double ratio);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "render/marks/port_drag.h"
#include "render/marks/port_mark.h"
#include "render/slice/pane_axes.h"
#include "render/slice/pane_grid.h"
#include "render/slice/slice_pixels.h"
#include "render/slice/slice_raster.h"

class vtkRenderer;

namespace angiomesh {

struct SliceWords;

/// A level set whose zero contour a slice shows; it may live on another grid than the image.
struct ContourLayer {
  std::shared_ptr<const Volume<float>> phi;
  std::array<double, 3> colour{1.0, 0.3, 0.2};  ///< RGB, 0..1
  double opacity = 1.0;
};

/// Of the outlines of a preview, RGB, 0..1.
inline constexpr std::array<double, 3> kPreviewColour{0.3, 0.95, 0.5};

/// One slice pane: the image's native voxels along one grid axis, or values between them in a plane
/// that is turned, with overlays. The scene is flat:
/// its world is the slice in mm, so that no direction matrix ever reaches the renderer. Display
/// coordinates are pixels of the window from the lower left corner, as VTK counts them.
class SliceScene {
 public:
  SliceScene();
  ~SliceScene();
  SliceScene(const SliceScene&) = delete;
  SliceScene& operator=(const SliceScene&) = delete;

  [[nodiscard]] vtkRenderer* renderer() const;

  /// Null shows nothing. Another geometry goes to the middle slice and fits; the same one (another
  /// layer of the same grid) keeps slice, zoom and pan.
  void setImage(std::shared_ptr<const Volume<float>> image);
  [[nodiscard]] const std::shared_ptr<const Volume<float>>& image() const;
  void setPlane(int plane);                    ///< 0 sagittal, 1 coronal, 2 axial
  [[nodiscard]] const PaneAxes& axes() const;  ///< in grid()
  /// That the slices are of: the image's, unless the planes are turned or along the patient's axes.
  [[nodiscard]] const Geometry& grid() const;
  [[nodiscard]] const SlicePlane& plane() const;
  [[nodiscard]] const SlicePixels& pixels() const;

  /// How all three planes lie. The crosshair stays where it is seen.
  void setTurn(const PlaneTurn& turn);
  [[nodiscard]] const PlaneTurn& turn() const;
  /// Whether one of the crosshair's knobs, which turn the other planes, lies at a display position.
  [[nodiscard]] bool knobAt(double displayX, double displayY) const;
  [[nodiscard]] std::vector<Eigen::Vector2d> knobs() const;  ///< their display positions
  /// Of a display position around the crosshair, radians, anticlockwise.
  [[nodiscard]] double angleAt(double displayX, double displayY) const;
  /// `from` with the other planes turned about the crosshair, anticlockwise in this pane.
  [[nodiscard]] PlaneTurn turnedBy(const PlaneTurn& from, double radians) const;

  /// Over the image.
  void setColourLayer(const ColourLayer& layer);

  void setWindowLevel(double window, double level);
  [[nodiscard]] double window() const;
  [[nodiscard]] double level() const;

  void setInterpolated(bool on);  ///< between voxels; else each is drawn in one shade

  void setSlice(int slice);  ///< index along axes().across, clamped
  [[nodiscard]] int slice() const;
  [[nodiscard]] int sliceCount() const;

  /// Around the slice; it stays on while scrolling.
  void setSlab(const Slab& slab);
  [[nodiscard]] const Slab& slab() const;

  void setCursor(const Eigen::Vector3d& lps);  ///< the crosshair; does not change the slice
  [[nodiscard]] Eigen::Vector3d cursor() const;
  void setCrosshairVisible(bool visible);
  void setContours(std::vector<ContourLayer> contours);
  /// Seeds by hand, and fainter those that were found.
  void setSeeds(std::vector<Eigen::Vector3d> byHand, std::vector<Eigen::Vector3d> found = {});
  [[nodiscard]] const std::vector<Eigen::Vector3d>& seeds() const;  ///< by hand
  /// The seed by hand that is seen at a display position.
  [[nodiscard]] std::optional<std::size_t> seedAt(double displayX, double displayY) const;
  void setPorts(std::vector<PortMark> marks);
  [[nodiscard]] const std::vector<PortMark>& ports() const;
  /// The movable port whose mark is seen at a display position.
  [[nodiscard]] std::optional<PortHit> portAt(double displayX, double displayY) const;
  [[nodiscard]] PortDrag grabPort(const PortHit& hit, double displayX, double displayY) const;
  /// Through the slice, across it.
  [[nodiscard]] ViewRay rayAt(double displayX, double displayY) const;
  void setWords(const SliceWords& words);
  /// Lines under the slab in the upper right corner, on what the pane shows.
  void setCaption(const std::string& lines);
  /// Lines above window and level in the lower left corner, on what is under the pointer.
  void setPointerText(const std::string& lines);
  void setRoi(const std::optional<RoiBox>& roi);
  [[nodiscard]] const std::optional<RoiBox>& roi() const;
  /// Outlines the voxels of a grid, those of a preview.
  void setPreviewGrid(const std::optional<Geometry>& grid);

  void fit();
  void zoom(double factor, double displayX, double displayY);  ///< about a display position
  void pan(double displayDx, double displayDy);
  /// Pixels of the screen per pixel that text and lines are designed for; the view keeps its part
  /// of the slice.
  void setPixelRatio(double ratio);

  /// Patient position on the slice under a display position; also outside the image.
  [[nodiscard]] Eigen::Vector3d lpsAt(double displayX, double displayY) const;
  /// Display position of the foot of `lps` on the slice.
  [[nodiscard]] Eigen::Vector2d displayAt(const Eigen::Vector3d& lps) const;
  /// The slice nearest to `lps`, clamped.
  [[nodiscard]] int sliceAt(const Eigen::Vector3d& lps) const;
  /// The value shown at the pixel nearest to `lps`, and where it comes from: in a MIP or MinIP slab
  /// the place of the extreme value, else that in the slice, with the nearest voxel. Nothing
  /// outside the image.
  using Probe = SlicePixels::Probe;
  [[nodiscard]] std::optional<Probe> probe(const Eigen::Vector3d& lps) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh

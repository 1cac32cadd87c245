// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/image/volume.h"
#include "render/slice/pane_axes.h"

namespace angiomesh {

enum class SlabMode { None, Mip, MinIp, Mean };
constexpr int kSlabModeCount = 4;

/// What a slice pane projects.
struct Slab {
  SlabMode mode = SlabMode::None;
  double thicknessMm = 10.0;  ///< of the next one, too, while there is none

  bool operator==(const Slab&) const = default;
};

/// x0, y0, z0, x1, y1, z1 in mm LPS, each lower bound first.
using RoiBox = std::array<double, 6>;

/// A slice of a grid as it lies on the screen: (x, y) in mm from the centre of its lower left
/// pixel, x to the right, y upwards.
class SlicePlane {
 public:
  SlicePlane() = default;
  SlicePlane(const Geometry& geometry, const PaneAxes& axes, int slice);

  [[nodiscard]] int width() const { return width_; }    ///< pixels
  [[nodiscard]] int height() const { return height_; }  ///< pixels
  [[nodiscard]] double pixelWidthMm() const { return pixelWidth_; }
  [[nodiscard]] double pixelHeightMm() const { return pixelHeight_; }
  [[nodiscard]] Eigen::Vector3d toLps(const Eigen::Vector2d& xy) const;
  /// (x, y) of the foot of a point, and its distance from the slice in slices (rising index).
  [[nodiscard]] Eigen::Vector3d fromLps(const Eigen::Vector3d& lps) const;

 private:
  Geometry geometry_;
  PaneAxes axes_;
  int slice_ = 0, width_ = 0, height_ = 0;
  double pixelWidth_ = 1.0, pixelHeight_ = 1.0;
};

/// The zero level set of `phi` (any grid of the same patient space, interpolated trilinearly) in
/// the plane, as separate line segments in the plane's mm. Nothing is drawn outside phi's grid.
std::vector<std::array<Eigen::Vector2d, 2>> zeroContour(const Volume<float>& phi,
                                                        const SlicePlane& plane);

/// Where a box of patient space cuts the plane: a convex polygon, empty when it does not.
std::vector<Eigen::Vector2d> boxSection(const RoiBox& box, const SlicePlane& plane);
/// The same of the box that the voxels of a grid fill.
std::vector<Eigen::Vector2d> gridSection(const Geometry& grid, const SlicePlane& plane);

/// `box` between two corners that were drawn on a pane of `plane` (0 sagittal, 1 coronal, 2 axial),
/// whose depth it keeps, within `whole`. Nothing where nothing would be left.
std::optional<RoiBox> boxBetween(RoiBox box, const RoiBox& whole, int plane,
                                 const Eigen::Vector3d& corner, const Eigen::Vector3d& other);

/// The box of the voxels' outer faces: bounds of the whole volume in patient space.
RoiBox volumeBox(const Geometry& geometry);

/// Values at two fractions (0..1) of the sorted voxels, from at most some 10^5 of them.
std::array<double, 2> displayRange(const Volume<float>& image, double low, double high);

}  // namespace angiomesh

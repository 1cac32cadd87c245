// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/image/volume.h"

namespace angiomesh {

/// A voxel near a wall. Lengths in working voxels, positions the index times the spacing in working
/// voxels along each axis.
struct WallCell {
  std::uint32_t voxel = 0;
  float distance = 0.0F;                             ///< from the wall, negative inside
  Eigen::Vector3f foot = Eigen::Vector3f::Zero();    ///< the point of the wall next to it
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< outward, unit, at the foot
};

/// The voxels within a reach of the zero set of a level set function, in the order of memory.
class WallCells {
 public:
  /// @param phi signed distance, mm
  WallCells(const Volume<float>& phi, double reachVoxels);

  /// Finds feet, normals and distances of all cells on the zero set of `phi`, which has the same
  /// grid.
  void place(const SplineField& phi, const Progress& progress);

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] const WallCell& operator[](std::size_t n) const { return cells_[n]; }

  /// Calls visit(n) for the cells whose voxels lie within `half` of a position along each axis.
  template <class Visit>
  void forBox(const Eigen::Vector3f& at, const Eigen::Vector3f& half, const Visit& visit) const;

 private:
  Index3 grid_;
  Eigen::Vector3f step_;  ///< working voxels per voxel
  float voxelMm_;
  std::vector<WallCell> cells_;
  std::vector<std::uint32_t> rows_;  ///< where the cells of each row of voxels begin
  std::vector<std::uint16_t> columns_;
};

/// Whether two places can belong to one stretch of wall: not to walls that face each other across a
/// gap, nor to walls one behind the other.
inline bool onOneWall(const WallCell& a, const WallCell& b) {
  const Eigen::Vector3f way = b.foot - a.foot;
  if (a.normal.dot(b.normal) < 0.0F && way.dot(b.normal - a.normal) < 0.0F) return false;
  return std::fabs(way.dot(a.normal + b.normal)) < 0.5F + 0.8F * way.norm();
}

/// How windows on a wall lie at a cell: longer along the vessel than around it.
struct VesselFrame {
  float radius = 0.0F;  ///< of the vessel, working voxels, at most kThick
  Eigen::Vector3f axis = Eigen::Vector3f::Zero();  ///< unit
  float stretch = 1.0F;                            ///< along the axis
  static constexpr float kThick = 8.0F;

  /// The square of a distance that counts less along the axis.
  [[nodiscard]] float square(const Eigen::Vector3f& way) const {
    const float along = way.dot(axis);
    return way.squaredNorm() - (1.0F - 1.0F / (stretch * stretch)) * along * along;
  }
  /// Half the sides of the box around the window square() < radius^2.
  [[nodiscard]] Eigen::Vector3f half(float window) const {
    return window *
           (Eigen::Vector3f::Ones() + (stretch * stretch - 1.0F) * axis.cwiseAbs2()).cwiseSqrt();
  }
};

/// The frames of the cells within `reachVoxels` of the wall (others stay empty). The radius is the
/// depth that phi reaches inwards from the wall; the axis is the direction in which the normals of
/// the wall around turn least.
std::vector<VesselFrame> vesselFrames(const Volume<float>& phi, const WallCells& cells,
                                      double reachVoxels, double stretch, const Progress& progress);

template <class Visit>
void WallCells::forBox(const Eigen::Vector3f& at, const Eigen::Vector3f& half,
                       const Visit& visit) const {
  Index3 low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    low[a] = std::max(0, static_cast<int>(std::ceil((at[axis] - half[axis]) / step_[axis])));
    high[a] =
        std::min(grid_[a] - 1, static_cast<int>(std::floor((at[axis] + half[axis]) / step_[axis])));
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j) {
      const std::size_t row = static_cast<std::size_t>(j) +
                              static_cast<std::size_t>(grid_[1]) * static_cast<std::size_t>(k);
      for (std::uint32_t n = rows_[row]; n < rows_[row + 1]; ++n) {
        if (columns_[n] < low[0]) continue;
        if (columns_[n] > high[0]) break;
        visit(static_cast<std::size_t>(n));
      }
    }
}

}  // namespace angiomesh

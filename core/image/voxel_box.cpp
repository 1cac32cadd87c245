// SPDX-License-Identifier: BSD-3-Clause
#include "core/image/voxel_box.h"

#include <cmath>

#include "core/image/voxels.h"

namespace angiomesh {

VoxelBox VoxelBox::widened(int voxels, const Geometry& grid) const {
  VoxelBox wide = *this;
  for (std::size_t a = 0; a < 3; ++a) {
    wide.low[a] = std::max(low[a] - voxels, 0);
    wide.high[a] = std::min(high[a] + voxels, grid.size[a] - 1);
  }
  return wide;
}

VoxelBox VoxelBox::seenFrom(const VoxelBox& other) const {
  VoxelBox seen = *this;
  for (std::size_t a = 0; a < 3; ++a) {
    seen.low[a] -= other.low[a];
    seen.high[a] -= other.low[a];
  }
  return seen;
}

std::size_t VoxelBox::voxelCount() const {
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) count *= static_cast<std::size_t>(high[a] - low[a] + 1);
  return count;
}

VoxelBox boxAround(const Geometry& grid, const Eigen::Vector3d& middleLps, const Index3& sides) {
  const Eigen::Vector3d middle = grid.toIndex(middleLps);
  VoxelBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const int side = std::clamp(sides[a], 2, grid.size[a]);
    const auto first =
        static_cast<int>(std::lround(middle[static_cast<Eigen::Index>(a)] - 0.5 * (side - 1)));
    box.low[a] = std::clamp(first, 0, grid.size[a] - side);
    box.high[a] = box.low[a] + side - 1;
  }
  return box;
}

std::optional<VoxelBox> boxOf(const Geometry& grid, const std::vector<Eigen::Vector3d>& pointsLps,
                              double reachMm) {
  Eigen::Vector3d least = grid.toIndex(pointsLps.front()), most = least;
  for (const Eigen::Vector3d& point : pointsLps) {
    const Eigen::Vector3d index = grid.toIndex(point);
    least = least.cwiseMin(index);
    most = most.cwiseMax(index);
  }
  VoxelBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double reach = reachMm / grid.spacing[axis];
    const double last = grid.size[a] - 1.0;
    const double from = std::max(std::ceil(least[axis] - reach), 0.0);
    const double to = std::min(std::floor(most[axis] + reach), last);
    if (!(from <= to)) return std::nullopt;
    box.low[a] = static_cast<int>(from);
    box.high[a] = static_cast<int>(to);
  }
  return box;
}

Geometry croppedGrid(const Geometry& grid, const VoxelBox& box) {
  Geometry part = grid;
  part.origin = voxelCentre(grid, box.low);
  for (std::size_t a = 0; a < 3; ++a) part.size[a] = box.high[a] - box.low[a] + 1;
  return part;
}

}  // namespace angiomesh

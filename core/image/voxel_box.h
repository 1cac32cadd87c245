// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>

#include "core/image/volume.h"

namespace angiomesh {

/// Voxels of a grid from `low` to `high`, these included.
struct VoxelBox {
  Index3 low{0, 0, 0}, high{0, 0, 0};

  bool operator==(const VoxelBox&) const = default;

  [[nodiscard]] bool holds(const Index3& p) const {
    return p[0] >= low[0] && p[0] <= high[0] && p[1] >= low[1] && p[1] <= high[1] &&
           p[2] >= low[2] && p[2] <= high[2];
  }
  /// `voxels` more in each direction, as far as the grid goes.
  [[nodiscard]] VoxelBox widened(int voxels, const Geometry& grid) const;
  /// Its numbers counted from another box's lower corner.
  [[nodiscard]] VoxelBox seenFrom(const VoxelBox& other) const;
  [[nodiscard]] std::size_t voxelCount() const;
};

/// The box of at most `sides` voxels, in the grid, whose middle is the voxel nearest to a point;
/// beside a border it is moved inwards.
VoxelBox boxAround(const Geometry& grid, const Eigen::Vector3d& middleLps, const Index3& sides);

/// The voxels of the grid within `reachMm`, along its axes, of the box around
/// one or more points; nothing where that lies beyond the grid.
std::optional<VoxelBox> boxOf(const Geometry& grid, const std::vector<Eigen::Vector3d>& pointsLps,
                              double reachMm);

/// The grid of a box's voxels.
Geometry croppedGrid(const Geometry& grid, const VoxelBox& box);

/// The voxels of a box. @pre it lies in the image
template <class T>
Volume<T> cropped(const Volume<T>& image, const VoxelBox& box) {
  Volume<T> part(croppedGrid(image.geometry, box));
  const Index3& size = part.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      std::copy_n(&image.at(box.low[0], box.low[1] + j, box.low[2] + k), size[0],
                  &part.at(0, j, k));
  return part;
}

}  // namespace angiomesh

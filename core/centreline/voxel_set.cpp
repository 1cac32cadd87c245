// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/voxel_set.h"

#include <cmath>

namespace angiomesh {

VoxelSet::VoxelSet(const Volume<std::int32_t>& labels, std::int32_t lastLabel)
    : geometry_(labels.geometry) {
  const auto width = static_cast<std::size_t>(geometry_.size[0]);
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    if (i % width == 0) rowStart_.push_back(static_cast<std::uint32_t>(voxels_.size()));
    const std::int32_t label = labels.voxels[i];
    if (label > 0 && label <= lastLabel) voxels_.push_back(static_cast<std::uint32_t>(i));
  }
  rowStart_.push_back(static_cast<std::uint32_t>(voxels_.size()));
  for (int bits = 0; bits < 8; ++bits) {
    double square = 0.0;
    for (int a = 0; a < 3; ++a)
      if ((bits >> a & 1) != 0) square += geometry_.spacing[a] * geometry_.spacing[a];
    lengths_[static_cast<std::size_t>(bits)] = std::sqrt(square);
  }
}

std::optional<std::uint32_t> VoxelSet::numberAt(const Eigen::Vector3d& position) const {
  Index3 p;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    p[a] = static_cast<int>(std::floor(position[axis] / geometry_.spacing[axis] + 0.5));
  }
  std::optional<std::uint32_t> found;
  forRow(p[0], p[0], p[1], p[2],
         [&](std::size_t n, int) { found = static_cast<std::uint32_t>(n); });
  return found;
}

}  // namespace angiomesh

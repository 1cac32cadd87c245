// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// The voxels where v >= b, in 26-connected parts of at least `leastVoxels` or that hold a voxel in
/// a sphere around a seed (mm LPS, radius in working voxels), and those voxels: 1, or 2 where v >=
/// 3 b.
Volume<std::uint8_t> floodVessels(const Volume<float>& vesselness, double b,
                                  const std::vector<Eigen::Vector3d>& seedsLps, double radiusVoxels,
                                  std::size_t leastVoxels);

/// The start of an evolution from what floodVessels() found: its surface at v = b where that is at
/// hand, else half-way between voxels, within +-0.5 working voxel.
Volume<float> floodStart(const Volume<float>& vesselness, double b,
                         const Volume<std::uint8_t>& found);

}  // namespace angiomesh

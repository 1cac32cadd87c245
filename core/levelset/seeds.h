// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

struct SeedParams {
  bool automatic = true;
  double topPercent =
      0.05;            ///< of all voxels with positive vesselness at the single scale sigma_avg
  double least = 0.1;  ///< and at least so much, but for the best one: the share may exceed what
                       ///< is vessel
  double radiusVoxels = 1.0;   ///< of the starting spheres, working voxels
  std::vector<double> points;  ///< x,y,z,... LPS mm: seeds by hand, added to the automatic ones

  bool operator==(const SeedParams&) const = default;
};

/// Seeds as positions in LPS mm, in order of memory; seeds by hand last.
/// `single` is the vesselness at sigma_avg (thesis 3.3).
/// @throws InputError when a given point lies outside the volume
/// @throws NumericError when there is no seed at all
std::vector<Eigen::Vector3d> findSeeds(const Volume<float>& single, const SeedParams& params);

/// Signed distance in working voxels to the union of spheres of `radiusVoxels` around the seeds, by
/// fast marching (Sethian 1996) out to 4 working voxels from the surface; beyond: +4.
Volume<float> fastMarchingStart(const Geometry& geometry,
                                const std::vector<Eigen::Vector3d>& seedsLps, double radiusVoxels);

/// Offsets of the voxels whose centres lie within a sphere around any of the seeds (mm LPS), in
/// ascending order. @param radiusVoxels in working voxels
std::vector<std::size_t> voxelsAroundSeeds(const Geometry& geometry,
                                           const std::vector<Eigen::Vector3d>& seedsLps,
                                           double radiusVoxels);

}  // namespace angiomesh

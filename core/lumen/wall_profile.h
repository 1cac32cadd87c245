// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/distance/cell_band.h"
#include "core/lumen/wall_cells.h"

namespace angiomesh {

/// What an image tells about a wall: its values at some voxels, those of lumen and surroundings
/// there, all of them turned so that vessels are bright, and their noise.
struct WallEvidence {
  CellBand band;                            ///< those voxels
  std::vector<float> value, lumen, around;  ///< per cell of the band
  double noise = 0.0;                       ///< standard deviation of `value`
  int meanSteps = 0;  ///< of averaging the lumen's brightness along vessels, see meanAlong()
};

/// The standard deviation of the place of a square voxel of wall, working voxels, by the ratio of
/// noise to contrast: from Fisher's information, contrast^2 / (2 sqrt(pi) s noise^2), of voxels
/// that see the wall through a point spread of s = 0.6 working voxels.
double wallUncertainty(double noiseToContrast);

/// The curvature of a wall at a cell's foot: sum and product of the principal curvatures, per
/// working voxel.
struct WallBend {
  float mean = 0.0F, gauss = 0.0F;
};

/// The share of the lumen's brightness over the surroundings' that a point at a signed distance
/// from a wall has, seen through a Gaussian point spread: Phi(-x), x = (d + s^2 (k1 + k2) / 2) / s,
/// k1 and k2 the curvatures of the level set through the point. Exact on planes; to second order in
/// s k elsewhere (0.002 on the wall of a cylinder of radius 2.6 s).
struct WallProfile {
  double spread = 0.5;  ///< s, working voxels

  [[nodiscard]] double argument(double distance, const WallBend& bend) const;
  static double share(double argument);
  /// How fast the share rises when the wall moves outwards, per working voxel.
  [[nodiscard]] double slope(double argument) const;
};

/// The point spread that explains the image best around the walls of vessels of a radius of at
/// least 2 working voxels, or 1.2 where those are few; by 50,000 cells at most. 0 where there are
/// too few.
/// @param number per cell, where it stands in `evidence`; kNoEvidence where it does not
/// @param radius of the vessel at each cell, working voxels; 0 unknown
double measureSpread(const WallCells& cells, const WallEvidence& evidence,
                     const std::vector<std::uint32_t>& number, const std::vector<float>& radius,
                     const std::vector<WallBend>& bends);

constexpr std::uint32_t kNoEvidence = 0xffffffffU;

}  // namespace angiomesh

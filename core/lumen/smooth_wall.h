// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/lumen/wall_profile.h"

namespace angiomesh {

/// How a wall is made smooth.
struct SmoothWallParams {
  bool enabled = true;
  /// Radius of the window that each place of the wall is found from: times the fourth root of the
  /// product of the vessel's radius and the uncertainty of a square voxel of wall, all in working
  /// voxels. Bias grows with the window and noise falls with it; the power balances them over
  /// radii of 1.3 to 6 voxels and noise up to a quarter of the contrast.
  double reach = 5.5;
  std::optional<double> spreadVoxels;  ///< of the image's point spread; empty: measured

  bool operator==(const SmoothWallParams&) const = default;
};

/// What came of it.
struct SmoothWall {
  Volume<float> phi;          ///< mm, to be redistanced; beyond 2.3 working voxels as it was
  double spreadVoxels = 0.0;  ///< of the point spread; 0 where it could not be measured
  std::size_t heldVoxels =
      0;  ///< kept on their side, as the vessel would have come apart or closed
};

/// The wall as smooth as the vessel is. At each place a quadric is fitted to the wall around it,
/// and then, twice, to where the image says that the wall is: each voxel within 1.3 working voxels
/// of the wall is compared with what the wall found before looks like through the scanner's point
/// spread (see WallProfile), and weighs as much as it can tell. Windows follow the vessel, twice as
/// long along it as around it. Cylinders, cones of small angle, balls and planes are left as they
/// are by the fit, whatever the window. Where no voxel of a vessel is full, its brightness is taken
/// from what the profile says that its voxels are (changes `evidence`). Topology (26-connected
/// vessels) stays; no voxel's value changes by more than 0.9 working voxel.
///
/// Without `evidence`, as of a mask of another program, the image is the sign of `phi`: voxels that
/// are full or empty, which the profile of an evenly filled voxel explains. The wall is uncertain
/// by half a voxel to either side then.
/// @param phi signed distance in mm, clamped at 5 working voxels (see redistance())
/// @throws Cancelled
SmoothWall smoothWall(Volume<float> phi, WallEvidence* evidence, const SmoothWallParams& params,
                      const Progress& progress = {});

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/lumen/wall_profile.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

/// How the wall is placed between the lumen and its surroundings.
struct LumenParams {
  bool enabled = true;
  /// Of the way from the surroundings' brightness to the lumen's, what a voxel of the vessel has at
  /// least: less than half, so that one through whose centre the wall runs belongs to it. The wall
  /// itself lies half-way, or here if this is more.
  double level = 0.41;
  /// Weights of smoothing along and across the vessels, times the squared ratio of noise to
  /// contrast.
  double along = 14.0, across = 0.4;
  /// Of averaging the lumen's brightness along the vessels, each 2/3 voxel^2; 0: what is near in
  /// space alone counts.
  int meanSteps = 100;
  double reachVoxels = 3.0;  ///< from what was found to where the wall is looked for

  bool operator==(const LumenParams&) const = default;
};

/// Where vessels have been found (1; 2 at their cores, which tell vessels apart), the wall anew:
/// between the local brightness of the lumen and that of the surroundings, in the image smoothed
/// along the vessels as much as its noise asks for. Cores that meet end to end, or in full
/// brightness, are joined; those that lie side by side stay apart.
/// @param evidence if given: what the image tells about the wall in the band that was looked at
/// @return negative inside, about the distance to the wall in working voxels near it
Volume<float> refineLumen(const Volume<float>& image, const Volume<std::uint8_t>& found,
                          const LumenParams& params, Polarity polarity,
                          const Progress& progress = {}, WallEvidence* evidence = nullptr);

}  // namespace angiomesh

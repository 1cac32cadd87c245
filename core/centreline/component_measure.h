// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// A piece of a round vessel.
struct VesselPiece {
  double lengthMm = 0.0, radiusMm = 0.0;
};

/// Size of one connected part of a segmentation.
struct ComponentMeasure {
  /// Of its centre lines, all branches together. A centre line ends where the vessel leaves the
  /// volume, else as far from the tip as the vessel is thick there (at the centre of a ball's end).
  /// 0: not longer than it is thick.
  double lengthMm = 0.0;
  /// Of round vessels of this length that hold the part's volume, half a ball at each tip.
  double meanRadiusMm = 0.0;
  /// The centre lines from voxel to voxel, lengthMm in all, as thick as the wall is near, all by
  /// the same length thicker or thinner so that they hold the part's volume. Empty where lengthMm
  /// is 0.
  std::vector<VesselPiece> pieces;
  int tips = 2;  ///< ends inside the volume, each half a ball
};

/// The parts labelled 1..count (26-connected voxels where phi < 0). Centre lines are cheapest paths
/// from tip to tip through the voxels, a step's cost its length over the squared distance to the
/// wall (after Sato et al., TEASAR, 2000), smoothed over a few voxels; branches that stick out less
/// than 2 working voxels and a third of the vessel's radius are none, rings are closed.
/// @param phi signed distance in mm, negative inside, clamped at 5 working voxels or more
std::vector<ComponentMeasure> measureComponents(const Volume<float>& phi,
                                                const Volume<std::int32_t>& labels,
                                                std::size_t count, const Progress& progress = {});

}  // namespace angiomesh

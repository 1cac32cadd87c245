// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"

namespace angiomesh {

/// A point of the tree and the vessel that leads to it from its parent.
struct VesselNode {
  Eigen::Vector3d position;
  int parent = -1;             ///< -1 at a root
  int children[2] = {-1, -1};  ///< none at a terminal, one at a root, two at a bifurcation
  double flow = 0.0;           ///< of the vessel, in units of the smallest terminal's
  double length = 0.0;         ///< of the vessel
};

/// Lengths in voxels; the tissue is the box from 0 to `extent`.
struct GrowthParams {
  Eigen::Vector3d extent;
  std::uint64_t seed = 1;
  double radiusOfUnitFlow = 0.8;
  double meanFlow = 2.0;  ///< of the terminals, at least 1
  int roots = 1;
  double maximumFlow = 1000.0;  ///< of a root
  double expectedFlow = 500.0;  ///< of a root at the end, from which room is kept for thick vessels
  double volume = 0.0;          ///< of the vessels, where the growth ends
  int terminals = 0;            ///< where it ends, if more than 0 (then `volume` is not looked at)
};

/// Grows trees that supply the box: terminals appear where the oxygen demand is not met, that is,
/// far from the vessels; each is joined to the vessel where the whole tree's volume grows least,
/// with the bifurcation at the point that minimises the volume, under Murray's law and so radii
/// proportional to the cube root of the flow. After Hamarneh and Jassi, "VascuSynth: simulating
/// vascular trees for generating volumetric image data with ground-truth segmentation and tree
/// analysis", 2010. Ends early when no vessel fits any more or all roots are at their maximum.
std::vector<VesselNode> growVessels(const GrowthParams& params, const Progress& progress);

/// Sum of pi r^2 length, radii as in `params`.
double vesselVolume(const std::vector<VesselNode>& nodes, double radiusOfUnitFlow);

}  // namespace angiomesh

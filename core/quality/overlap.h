// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// `truth` of report.json. overlap = 100 * 2TP / (2TP + FP + FN); sensitivity = TP / (TP + FN),
/// precision = TP / (TP + FP), both fractions; distances between the surface voxels of the two
/// masks (voxels with a 6-neighbour of the other kind), symmetric, mm. 95 % Hausdorff: the larger
/// of the two directed 95th percentiles. Both distances are NaN when one mask has no surface and
/// the other has, for example when the result is empty. The volume's border is not a surface.
struct OverlapMeasures {
  double overlap = 0.0, sensitivity = 0.0, precision = 0.0;
  double assdMm = 0.0, hd95Mm = 0.0;
};

/// Eq. 5.3 of the thesis: percentages of all voxels, and the overlap, 100 * 2TP / (2TP + FP + FN).
struct VoxelRatios {
  double truePositive = 0.0, falsePositive = 0.0, trueNegative = 0.0, falseNegative = 0.0;
  double overlap = 0.0;
};

/// Both masks must have the same geometry.
/// @throws InputError when they do not, or when the truth is empty
VoxelRatios voxelRatios(const Volume<std::uint8_t>& result, const Volume<std::uint8_t>& truth);

/// Compares on the truth's grid; both masks must have the same geometry.
/// @throws InputError when they do not, or when the truth is empty
OverlapMeasures compareMasks(const Volume<std::uint8_t>& result, const Volume<std::uint8_t>& truth,
                             const Progress& progress = {});

/// phi sampled trilinearly at the voxel centres of `grid`: 1 where below `level`; 0 outside phi's
/// volume (which ends half a voxel beyond its outermost voxel centres). Where a centre lies within
/// 0.001 voxel of one of phi's, phi's own value decides.
Volume<std::uint8_t> maskOnGrid(const Volume<float>& phi, const Geometry& grid, double level = 0.0);

}  // namespace angiomesh

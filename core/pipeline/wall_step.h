// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/lumen/smooth_wall.h"
#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// Completes a result by the wall that was placed voxel by voxel: closes holes and cuts handles
/// that the wall's uncertainty explains, each named in `warnings`, and makes the wall smooth. Where
/// params.enabled is false the wall stays as it was placed. Of an image without a point spread of
/// 0.4 working voxels or more, whose voxels say by themselves how full they are, and of a mask the
/// segmentation stays that of voxels (EvolveResult::voxelwise); else it is the smooth wall's.
/// @param phi signed distance, mm, clamped at +-5 working voxels
/// @param evidence null of a mask, whose handles stay: nothing speaks against them
/// @throws Cancelled
void placeWall(Volume<float> phi, WallEvidence* evidence, const SmoothWallParams& params,
               EvolveResult& result, std::vector<std::string>& warnings, const Progress& progress);

/// The smooth wall of a mask as a distance, by the mask's own distance (see distanceOfMask()).
Volume<float> smoothMask(Volume<float> phi, const SmoothWallParams& params,
                         const Progress& progress = {});

}  // namespace angiomesh

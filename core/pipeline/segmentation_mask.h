// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// The voxels of `grid` that belong to the vessels of a run, as far as it went: those whose centre
/// lies inside the wall. Where the wall before it was made smooth counts (EvolveResult::voxelwise),
/// levelset.refineLevel has a voxel through whose centre the wall runs among the vessel; on another
/// grid than the working one a voxel may then have its centre up to 0.5 - levelset.refineLevel
/// working voxels outside.
/// @param phi of the run (EvolveResult::phi, SurfaceResult::phi), or of some of its components
/// @throws InputError when the run did not get as far as the evolution
Volume<std::uint8_t> segmentationMask(const RunResult& result, const Volume<float>& phi,
                                      const Geometry& grid);

/// The same of what the run keeps, see keptPhi().
Volume<std::uint8_t> segmentationMask(const RunResult& result, const Geometry& grid);

}  // namespace angiomesh

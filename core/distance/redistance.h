// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// Signed distance in mm (negative inside) to the zero set of phi's interpolating cubic, clamped at
/// +-bandVoxels working voxels. Each grid point near the surface gets its closest point by Newton's
/// method on the interpolant (Chopp 2001), started from its neighbours' closest points, so that the
/// zero set moves by less than 0.01 voxel on smooth fields. Signs at the voxels never change. `phi`
/// in any unit.
/// @throws NumericError when phi has no zero set
Volume<float> redistance(Volume<float> phi, double bandVoxels = 5.0, const Progress& progress = {});

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// What a volume of vessels can hardly look like: axes that are not of length 1, whose length is
/// moved to the spacing, axes that are not at right angles, voxels or sides of a size that no scan
/// of vessels has. Says so in warnings; the place of no voxel changes.
std::vector<std::string> checkGeometry(Geometry& geometry);

/// Whether two grids are one and the same, but for the rounding of a header: 1e-4 of the spacing,
/// 1e-3 of the axes and a tenth of a voxel at the origin.
bool sameGrid(const Geometry& a, const Geometry& b);

}  // namespace angiomesh

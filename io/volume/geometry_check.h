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

}  // namespace angiomesh

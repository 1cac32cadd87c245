// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// Per triangle: 0 for a cap, a patch or one whose corners all lie in or beyond one plane of
/// outermost voxel centres of `grid`, 1 for the wall.
std::vector<char> wallTriangles(const TriMesh& mesh, const Geometry& grid);

}  // namespace angiomesh

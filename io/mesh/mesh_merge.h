// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// Makes points at one place, bit for bit, one point, unless the mesh is closed as it is: where it
/// touches itself then, it would no longer be a manifold. Returns how many points went.
std::size_t mergeEqualPoints(TriMesh& mesh);

struct OpenMerge {
  std::size_t points = 0;     ///< that became one with another
  std::size_t triangles = 0;  ///< that lost a side by that, and went
};

/// Closes cracks: of the points at edges of one triangle alone, each that lies within `distanceMm`
/// > 0 of another becomes the one of the lower number. All other points stay.
OpenMerge mergeOpenPoints(TriMesh& mesh, double distanceMm);

/// How many points mergeOpenPoints() would make one with another.
std::size_t openPointsNear(const TriMesh& mesh, double distanceMm);

}  // namespace angiomesh

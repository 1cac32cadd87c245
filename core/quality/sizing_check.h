// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "core/sizing/guidance_field.h"

namespace angiomesh {

/// How a mesh follows the wanted edge length g; caps do not count.
struct SizingCheck {
  double edgesInRangePercent = 0.0;  ///< of the edges: length / g at the midpoint in 0.7 to 1.4
  double edgeRatioMean = 0.0;        ///< mean of length / g
  std::size_t triangles = 0;         ///< of the wall
  double wantedTriangles = 0.0;      ///< the wall's area / (sqrt(3)/4 g^2), summed by triangles
};

/// Caps by wallTriangles() on `grid`.
/// @throws InputError (see checkMesh), Cancelled
SizingCheck checkSizing(const TriMesh& mesh, const GuidanceField& wanted, const Geometry& grid,
                        const Progress& progress = {});

}  // namespace angiomesh

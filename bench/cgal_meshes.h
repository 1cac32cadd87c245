// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/field/spline_field.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh::bench {

/// CGAL's isotropic remeshing, three iterations. `mesh` must be a 2-manifold.
TriMesh cgalIsotropicRemeshing(const TriMesh& mesh, double edgeMm);

struct DelaunayBounds {
  double angleDegrees = 30.0;
  double radiusMm = 1.0;    ///< of the balls around the facets
  double distanceMm = 0.1;  ///< of a facet from the centre of its ball
};

/// CGAL's Delaunay refinement of the zero set of `field`, which counts as outside beyond the grid.
TriMesh cgalDelaunayRefinement(const SplineField& field, const DelaunayBounds& bounds);

}  // namespace angiomesh::bench

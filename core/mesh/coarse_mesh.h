// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// A mesh to be looked at in place of a larger one.
struct CoarseMesh {
  TriMesh mesh;                     ///< no manifold in general; with the patches of the larger one
  std::vector<std::uint32_t> from;  ///< per triangle: the one of the larger mesh that it stands for
};

/// Some `triangles` triangles in place of those of `mesh`: vertices in one cell of a cubic grid
/// whose normals point into one octant become one (Rossignac and Borrel 1993). Without the normals
/// a vessel thinner than a cell would vanish.
CoarseMesh coarseMesh(const TriMesh& mesh, std::size_t triangles);

}  // namespace angiomesh

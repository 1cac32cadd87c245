// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/tri_mesh.h"
#include "core/openings/port.h"

namespace angiomesh {

/// Whether the mesh is one of triangles inscribed in the zero set of phi: 99.5 % of the vertices of
/// its wall within 0.01 voxel of phi = 0, and at most 1 % of its triangles with an angle below 20
/// degrees. The wall is what does not lie in a border plane of the grid (the outermost voxel
/// centres) and is no patch.
bool inscribedInZeroSet(const TriMesh& mesh, const SplineField& phi);

/// The same of each component by itself: 1 where it holds.
std::vector<char> inscribedComponents(const TriMesh& mesh, const MeshComponents& parts,
                                      const SplineField& phi);

/// Moves the vertices of an inscribed mesh along the wall's normal by the mean height of the zero
/// set over the flat triangles around them (the mean sagitta), and then by a common factor for each
/// component so that it encloses the zero set's volume. Vertices in border planes, of patches and
/// of open rims at `ports` stay in their planes: rims move by the mean height of phi = 0 over their
/// edges, so that each encloses the area of phi < 0 in its plane. Vertices inside flat caps, in
/// corners and where `frozen` is set stay in place. The same triangles and vertices come out.
/// @throws Cancelled
TriMesh offsetBySagitta(const TriMesh& mesh, const SplineField& phi, const std::vector<Port>& ports,
                        const std::vector<char>& frozen, const Progress& progress = {});

}  // namespace angiomesh

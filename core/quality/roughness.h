// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// How rough a mesh is, without knowing the true wall: 0 on balls and tubes of any size and
/// fineness, and on what bends slowly along its own radius.
///
/// Around a vertex, the vertices in a window one local radius wide (half the way through the
/// vessel, against the normal), at least 32 of them and two rings, are fitted by a smooth wall of
/// few terms (see LocalWall). From there
/// - spread: the root mean square distance of these vertices from it, over the degrees of freedom
///   that are left;
/// - angle: of each edge at the vertex, by how much the angle between its two triangles differs
///   from the one that they have with all four corners moved onto the fitted wall: what
///   neither the triangles' size nor the wall's curvature explains.
/// Waves longer than the window belong to the shape: on vessels of 1 to 2 voxels of radius those of
/// a voxel are seen in part only. Each is taken at up to 20,000 vertices spread evenly over the
/// list, fewer where a vessel has very many of them around it, weighted by area.
struct Roughness {
  double spreadMm = 0.0;    ///< median
  double spread95Mm = 0.0;  ///< 95th percentile; branchings and tips count as well
  double angleDeg = 0.0;    ///< median
  std::size_t places = 0;   ///< vertices where it was measured
};

/// @param wall of each triangle: 0 for one that does not count, such as a cap; empty: patches alone
/// do not count
/// Nothing when no place has enough vertices around it.
/// @throws InputError (see checkMesh), Cancelled
std::optional<Roughness> measureRoughness(const TriMesh& mesh, const std::vector<char>& wall = {},
                                          const Progress& progress = {});

/// The spread of each vertex, mm, where patches do not count: measured at the same places; the
/// vertices between them have that of the nearest by edges. Not a number where none is near.
/// @throws InputError (see checkMesh), Cancelled
std::vector<float> vertexSpreads(const TriMesh& mesh, const Progress& progress = {});

}  // namespace angiomesh

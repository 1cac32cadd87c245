// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// How many triangles meet at the vertices that lie on no open rim: 6 in an even mesh.
struct Valences {
  int least = 0, most = 0;
  double regularPercent = 0.0;  ///< with 5, 6 or 7 triangles
};
/// Nothing where all vertices lie on rims.
std::optional<Valences> measureValences(const TriMesh& mesh);

/// Per triangle, by how much the number of triangles at one of its corners differs from 6, at most.
/// Corners on open rims do not count; not a number where all three are.
std::vector<float> valenceDepartures(const TriMesh& mesh);

/// Per triangle, the ratio of its mean edge to that of the neighbour over an edge that differs most
/// from it, or the other way round: at least 1. Not a number where it has no neighbour.
std::vector<float> sizeGradations(const TriMesh& mesh);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// Smooths a mesh so that no triangles come to meet that did not before: calls `smooth`, which
/// leaves the vertices that are frozen (1 per vertex) and their edges as they are, keeps numbers
/// and components of vertices and triangles, and is given more frozen vertices, around the places
/// where triangles met, in each of some attempts. Components for which none was enough come back as
/// they were; their number is added to `left`.
/// @throws Cancelled
TriMesh smoothSoundly(const TriMesh& mesh,
                      const std::function<TriMesh(const std::vector<char>& frozen)>& smooth,
                      std::size_t& left, const Progress& progress);

}  // namespace angiomesh

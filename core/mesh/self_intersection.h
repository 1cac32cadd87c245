// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// The pairs of triangles (lower first, sorted) that meet outside the corners and edges they share
/// by index; exact. Degenerate triangles are left out: they are a fault of their own, and meet
/// their neighbours everywhere.
/// @throws Cancelled
std::vector<std::pair<std::uint32_t, std::uint32_t>> selfIntersections(
    const TriMesh& mesh, const Progress& progress = {});

}  // namespace angiomesh

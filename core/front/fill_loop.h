// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/front/front_surface.h"

namespace angiomesh {

/// Triangulates a closed loop of vertices without new ones, by dynamic programming (Liepa 2003):
/// even triangles that face as their vertices do weigh least. `taken(a, b)` tells the edges that
/// must not be used. Empty when there is no triangulation, or the loop has fewer than 3 or more
/// than 256 vertices.
std::vector<std::array<std::uint32_t, 3>> fillLoop(
    const std::vector<std::uint32_t>& loop, const std::vector<FrontPoint>& vertices,
    const std::function<bool(std::uint32_t, std::uint32_t)>& taken);

}  // namespace angiomesh

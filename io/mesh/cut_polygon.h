// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace angiomesh {

using CornerTriangles = std::vector<std::array<std::uint32_t, 3>>;

/// Cuts a polygon by ears, in the plane of its mean normal: n - 2 triangles of its n corners, by
/// their places in the list. Corners may lie at one place, as where a bridge joins a ring's two
/// outlines. Empty where it cannot be cut so: it crosses itself, has no area or winds too much.
CornerTriangles cutByEars(const std::vector<Eigen::Vector3d>& corners);

/// Whether triangles that a polygon was cut into lie over each other, seen along its mean normal.
bool foldsOver(const std::vector<Eigen::Vector3d>& corners, const CornerTriangles& triangles);

}  // namespace angiomesh

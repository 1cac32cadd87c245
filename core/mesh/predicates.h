// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace angiomesh {

/// Sign of the area of (a, b, c): 1 counter-clockwise, -1 clockwise, 0 exactly collinear.
/// Exact for finite coordinates whose products neither overflow nor underflow: a floating-point
/// filter, then expansion arithmetic (Shewchuk 1997).
int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// Sign of (b - a) x (c - a) . (d - a): 1 when d lies on the side from which (a, b, c) is
/// counter-clockwise, 0 when the four are exactly coplanar. Exact as orient2d().
int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             const Eigen::Vector3d& d);

}  // namespace angiomesh

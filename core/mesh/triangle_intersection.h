// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

namespace angiomesh {

using Triangle3 = std::array<Eigen::Vector3d, 3>;

/// Whether the corners are exactly collinear (or coincide).
bool isDegenerate(const Triangle3& t);

/// All tests are exact; triangles are closed sets and must not be degenerate.

/// Whether the triangles have a point in common (touching counts).
bool trianglesMeet(const Triangle3& s, const Triangle3& t);

/// The same for triangles with s[0] == t[0]: a common point other than that corner.
bool trianglesMeetBeyondCorner(const Triangle3& s, const Triangle3& t);

/// The same for triangles that share the edge (s[0], s[1]) and have the third corners s[2] and
/// `apex`: coplanar, and on the same side of the edge.
bool trianglesMeetBeyondEdge(const Triangle3& s, const Eigen::Vector3d& apex);

}  // namespace angiomesh

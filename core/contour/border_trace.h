// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/field/spline_field.h"
#include "core/openings/cut_away.h"
#include "core/openings/end_planes.h"

namespace angiomesh {

/// Where phi = 0 meets the planes that the surface ends in, as closed polylines that never cross.
struct BorderTrace {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::vector<Eigen::Vector3d> points;  ///< on phi = 0, LPS mm
  std::vector<std::uint32_t> next;  ///< per point; the inside lies to the right, seen from outside
  std::vector<Place> place;         ///< per point: the planes it lies in
};

/// Marching squares of the field in each border plane on a lattice `finer` times (a power of two)
/// the grid, in the cells where the field's bounds allow a zero; squares with two opposite corners
/// inside go by the value at their centre. The vertices are roots on the lattice's edges, shared
/// where two planes meet. Curves of what `away` takes are left out, and the outlines of its
/// sections added. Empty for a grid of one voxel along any axis.
BorderTrace traceBorder(const SplineField& field, const EndPlanes& ends, const CutAway& away,
                        int finer);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/field/spline_field.h"

namespace angiomesh {

/// A bound of the Hessian's spectral norm (per mm^2) of the spline over a box of index space inside
/// one cell (its lowest voxel), from the control points of the cell's Bezier form restricted to the
/// box: second differences of control points bound second derivatives (de Boor 1987).
double hessianBound(const SplineField& field, const Index3& cell, const Eigen::Vector3d& low,
                    const Eigen::Vector3d& high);

/// The least and the greatest that the gradient's part along `direction` (LPS, per mm) can be over
/// such a box: the hull of the Bernstein coefficients of that derivative, a polynomial of degree 3
/// in each variable.
std::array<double, 2> slopeBounds(const SplineField& field, const Index3& cell,
                                  const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                                  const Eigen::Vector3d& direction);

/// The bound of the Hessian over a whole cell.
double hessianBound(const SplineField& field, const Index3& cell);

}  // namespace angiomesh

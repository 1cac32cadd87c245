// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/field/spline_field.h"
#include "core/image/volume.h"

namespace angiomesh {

/// A signed distance d, bent where vessels are thin so that cubics on the grid can follow it. Along
/// the axis of a vessel d has an edge, which makes every interpolant ring at the wall beside it: by
/// 1.5 degrees at a radius of 1.3 voxels. Here d becomes d + c d^2 / 2; c is the larger principal
/// curvature of the wall, the mean of those around, taken from d outside where it is smooth. Of a
/// tube that is (rho^2 - r^2) / 2r, which has no edge. Deeper than where that turns, at -1 / c, it
/// stays; from 1.5 voxels outside on it turns back to d. Where c is below 1 / 3.5 voxels d stays.
/// Values at the wall, signs, and the gradient there stay.
/// @param phi signed distance, mm, clamped at 5 working voxels
Volume<float> withRoundRidges(const Volume<float>& phi);

/// The field whose zero set is the wall of a signed distance: withRoundRidges() but for `Bspline`,
/// which smooths by itself.
SplineField wallField(const Volume<float>& phi, SplineKind kind);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"

namespace angiomesh {

/// A wall triangle around which the field's gradient is not known to have a positive part along the
/// triangle's normal.
struct TurnedFace {
  std::uint32_t triangle = 0;
  bool measured = false;  ///< it has none at a point that was looked at; else no bound was enough
  double degrees = 0.0;   ///< the largest angle between the two that was measured
};

/// Bounds the gradient on each wall triangle and around it, as far as its feet on the zero set: by
/// its value at the centroid and a bound of the second derivatives, and where that is not enough by
/// the Bernstein coefficients of its part along the normal (see slopeBounds()) over boxes that are
/// halved until each is decided, to a limited depth. In the order of the triangles.
/// @throws Cancelled
std::vector<TurnedFace> turnedFaces(const PatchMesh& mesh, const SplineField& field,
                                    const Progress& progress);

}  // namespace angiomesh

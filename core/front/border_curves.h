// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/front/front_surface.h"
#include "core/openings/cut_away.h"
#include "core/openings/end_planes.h"

namespace angiomesh {

/// The curves in the planes that the surface ends in, which fronts start from.
struct BorderCurves {
  std::vector<FrontPoint> points;  ///< with the normals of phi
  std::vector<Place> place;
  using Loop = std::vector<std::uint32_t>;
  std::vector<Loop> rims;               ///< closed, the wall to the left seen from outside
  std::vector<std::vector<Loop>> caps;  ///< per plane: closed, the cap to the left
};

/// Rims: where phi = 0 meets the planes (traceBorder()), divided evenly by the wanted edge
/// length, which also follows the curve's own curvature (GuidanceField::idealLength())
/// and the distance to the curves' other parts in the same plane. With `caps` also the edges of the
/// volume inside phi, and the loops around each cap.
BorderCurves borderCurves(const SplineField& field, const GuidanceField& size,
                          const EndPlanes& ends, const CutAway& away, bool caps);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

struct InsidePoint {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};
  double depthMm = 0.0;  ///< distance from the surface
};

/// A point inside the component that encloses most, of a closed surface whose faces point outward:
/// the deepest of the middles of chords from some hundred triangles. Mesh generators ask for one to
/// tell the vessel from its surroundings. The winding number (van Oosterom and Strackee 1983)
/// confirms it. @throws InputError, also for an empty mesh   @throws NumericError when there is
/// none
InsidePoint pointInside(const TriMesh& mesh);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace angiomesh {

/// Which of the 27 voxels around (and at) a place belong to the object: bit (dx + 1) + 3 (dy + 1) +
/// 9 (dz + 1).
using Neighbourhood = std::uint32_t;

/// Whether the middle voxel may change sides without changing the topology of a 26-connected object
/// in a 6-connected background: the object around it is one 26-connected piece, and the background
/// that it touches across faces is one piece, 6-connected among the voxels that share a face or an
/// edge with it (Bertrand and Malandain 1994). The middle's own bit plays no part.
bool isSimplePoint(Neighbourhood object);

}  // namespace angiomesh

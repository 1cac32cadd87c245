// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

struct OutwardTurn {
  std::size_t closedParts = 0;
  std::size_t turnedParts = 0;
};

/// Turns round the closed parts of the mesh that face inward, by the sign of the volume that each
/// encloses. A part is edge-connected; it is closed when as many of its triangles run one way along
/// every edge as the other way. A part inside another closed one may bound a cavity or be a body of
/// its own, so its own sign tells nothing: it is turned when the outermost part around it is. Parts
/// that are not closed are left alone. Indices must be in range.
OutwardTurn turnOutward(TriMesh& mesh);

struct AlikeTurn {
  std::size_t turned = 0;    ///< triangles
  std::size_t oneSided = 0;  ///< parts that cannot be oriented, as a Moebius strip
};

/// Turns triangles round so that all of a part run along its edges of two triangles in opposite
/// ways; of two ways to do so, the one that turns fewer. A part is connected by such edges. Those
/// that are one-sided are left alone. Indices must be in range.
AlikeTurn turnAlike(TriMesh& mesh);

/// Whether every edge lies between exactly two triangles, and there is a triangle.
bool isClosed(const TriMesh& mesh);

}  // namespace angiomesh

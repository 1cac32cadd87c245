// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/image/projection.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// A surface with a line of text above it.
struct MeshPanel {
  const TriMesh* mesh;
  std::string title;
};

/// Surfaces of the same thing side by side: the whole above, the triangles within `detail` (x0, x1,
/// y0, y1, z0, z1, mm LPS) below, with their edges or without, each row seen by one camera. A panel
/// whose mesh has no triangles stays empty. Needs an X display; a virtual one will do.
/// @throws IoError when no display opens, InputError when no panel has a triangle, or none in
/// `detail`
Picture renderMeshPanels(const std::vector<MeshPanel>& panels, const std::array<double, 6>& detail,
                         int panelWidth, int panelHeight, bool edges = true);

}  // namespace angiomesh

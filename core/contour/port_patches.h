// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/contour/patch_mesh.h"
#include "core/openings/cut_away.h"
#include "core/openings/end_planes.h"
#include "core/openings/port.h"

namespace angiomesh {

/// Numbers the openings of a finished surface: sets mesh.mesh.patch, and returns the ports with
/// their names, as ZeroSetMesh::ports has them. An open rim is measured as the flat polygon that it
/// bounds.
std::vector<Port> numberPatches(PatchMesh& mesh, const EndPlanes& ends, const CutAway& away);

/// After components were taken out of a surface: ports that went with them go too; those left are
/// measured again and numbered anew, and those at the volume's border (all but the first `cuts`)
/// named anew. @returns the numbers of the cuts that went
std::vector<std::size_t> dropLostPorts(TriMesh& mesh, std::vector<Port>& ports, std::size_t cuts);

}  // namespace angiomesh

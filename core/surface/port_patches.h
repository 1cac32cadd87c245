// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/surface/cut_away.h"
#include "core/surface/end_planes.h"
#include "core/surface/patch_mesh.h"
#include "core/surface/port.h"

namespace angiomesh {

/// Numbers the openings of a finished surface: sets mesh.mesh.patch, and returns the ports with
/// their names, as ZeroSetMesh::ports has them. An open rim is measured as the flat polygon that it
/// bounds.
std::vector<Port> numberPatches(PatchMesh& mesh, const EndPlanes& ends, const CutAway& away);

/// After components were taken out of a surface: ports at the volume's border (all but the first
/// `cuts`) that went with them go too, and those left are numbered and named anew; the rest are
/// measured again.
void dropLostPorts(TriMesh& mesh, std::vector<Port>& ports, std::size_t cuts);

}  // namespace angiomesh

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

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/contour/patch_mesh.h"
#include "core/openings/cut_away.h"
#include "core/openings/section.h"

namespace angiomesh {

/// Takes from a reference surface (referenceSurface(), near phi = 0) what cuts take: triangles are
/// divided where they pass a section's outline, within the section's vessel alone, and the parts
/// beyond go, with all that lies on voxels that are taken. The sections become rims, see capCuts().
/// @throws InputError naming the cut where the reference has no such section (see checkSection()),
/// or both of its sides are one piece   @throws Cancelled
void clipReference(PatchMesh& reference, const CutAway& away, double voxelMm,
                   const Progress& progress = {});

/// That a reference surface of the field could be cut at this section.
/// @throws InputError naming the cut where the vessel is thinner than a voxel, or so near another
/// in the section's plane that marching cubes joins them, or where a point of the surface's rim at
/// the volume's border lies in that plane
void checkSection(const SplineField& field, const Section& section, const std::string& name);

/// cutAway() of cuts at which a reference surface could be cut.
/// @throws InputError as cutAway() and checkSection()   @throws Cancelled
CutAway checkedCutAway(const SplineField& field, const Volume<float>& phi,
                       const std::vector<CutPlane>& cuts,
                       const std::vector<std::string>& names = {}, const Progress& progress = {});

}  // namespace angiomesh

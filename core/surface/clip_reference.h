// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/surface/cut_away.h"
#include "core/surface/guidance_field.h"
#include "core/surface/marching_cubes.h"
#include "core/surface/patch_mesh.h"

namespace angiomesh {

/// Takes from a reference surface (referenceSurface(), near phi = 0) what cuts take: triangles are
/// divided where they pass a section's outline, within the section's vessel alone, and the parts
/// beyond go, with all that lies on voxels that are taken. With `Cap` the sections become flat caps
/// of triangles of the wanted size.
/// @throws InputError naming the cut where the reference has no such section (a vessel thinner than
/// a voxel, or a section that only the interpolant joins), or both of its sides are one piece
void clipReference(PatchMesh& reference, const CutAway& away, const SplineField& field,
                   const GuidanceField& size, const EndPlanes& ends, SurfaceBorder border,
                   const Progress& progress = {});

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"

namespace angiomesh {

/// The triangles at edges that do not join two faces of one orientation, and at vertices with more
/// than one fan; sorted. Rims in the planes that the surface ends in are no fault with `open`.
std::vector<std::uint32_t> brokenTriangles(const PatchMesh& mesh, bool open);

/// Takes out the given triangles with `rings` rings of triangles around them, as far as no vertex
/// of theirs lies in such a plane, and fills each hole by itself (FaceOrigin::Closing): a
/// manifold again, whose topology may differ there. Returns false, and leaves the mesh as it is,
/// where a hole can't be filled.
bool mendMesh(PatchMesh& mesh, const std::vector<std::uint32_t>& broken, int rings,
              const SplineField& field);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/image/projection.h"
#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// A lit picture of a surface: from anterior (from the feet when it
/// lies flat) on the left, obliquely on the right, with the outline
/// of `image` (may be null) around it. Needs an X display; a virtual one will do.
/// @throws IoError when no display opens, InputError when the mesh is empty
Picture renderSurfacePicture(const TriMesh& mesh, const Volume<float>* image, int width,
                             int height);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/image/projection.h"
#include "core/image/volume.h"
#include "core/surface/tri_mesh.h"

namespace angiomesh {

/// A lit picture of a surface: from anterior on the left, obliquely on the right, with the outline
/// of `image` (may be null) around it. Needs an X display; a virtual one will do.
/// @throws IoError when no display opens
Picture renderSurfacePicture(const TriMesh& mesh, const Volume<float>* image, int width,
                             int height);

/// The same, written as PNG to a temporary name, then renamed.
/// @throws IoError when no display opens or the file cannot be written
void renderSurfacePicture(const TriMesh& mesh, const Volume<float>* image, int width, int height,
                          const std::filesystem::path& path);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// How a surface ends where the vessel leaves the volume.
enum class SurfaceBorder {
  Cap,  ///< closed by a flat cap half a voxel outside the outermost voxel centres
  Open  ///< ends in an open rim on the outermost voxel centres
};

/// The zero set of phi (negative inside) by VTK's marching cubes, LPS mm, faces counter-clockwise
/// from outside. `Cap` pads phi by one outside layer, so that the result is closed. Values closer
/// to 0 than 1e-3 of a working voxel are moved to that distance on their own side (exactly 0 counts
/// as outside): it keeps vertices of different edges apart, so that no triangle is degenerate.
TriMesh marchingCubes(const Volume<float>& phi, SurfaceBorder border = SurfaceBorder::Cap,
                      const Progress& progress = {});

}  // namespace angiomesh

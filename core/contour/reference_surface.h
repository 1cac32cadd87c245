// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "core/base/progress.h"
#include "core/contour/marching_cubes.h"
#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"

namespace angiomesh {

/// A part of a field's grid, and how many times finer it is looked at.
struct GridPart {
  Index3 first{0, 0, 0}, last{0, 0, 0};  ///< voxels, inclusive
  int finer = 1;
};

/// The whole grid.
GridPart wholeGrid(const Geometry& grid);

/// Values of the field at the voxels of a part of its grid, or at points between them.
Volume<float> sampleField(const SplineField& field, const GridPart& part,
                          const Progress& progress = {});

/// Marching cubes of a field's values: wall vertices lie on grid edges, near phi = 0. With `Cap`
/// the flat caps in the outermost planes of `values` are part of it, and it is closed; such
/// planes that are not border planes of `ends` get no cap. Nothing is cut.
PatchMesh referenceSurface(const Volume<float>& values, const EndPlanes& ends, SurfaceBorder border,
                           const Progress& progress = {});

/// The triangles of patch 0, with all points.
TriMesh wallOf(const PatchMesh& patch);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/contour/marching_cubes.h"
#include "core/contour/patch_mesh.h"
#include "core/front/front_surface.h"
#include "core/openings/cut_away.h"
#include "core/openings/end_planes.h"

namespace angiomesh {

/// Places of the zero set that a mesh of it has to reach: the vertices of marching cubes, settled
/// on it.
struct Landmarks {
  std::vector<FrontPoint> points;
  std::vector<char> valid;               ///< per point: it lies on the zero set
  std::vector<std::uint32_t> component;  ///< per point: the smallest point of its component
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
Landmarks landmarksOf(const TriMesh& wall, const SplineField& field, const GuidanceField& size);

/// The zero set of `field` without what `away` takes, and its caps, meshed by advancing fronts: one
/// from each of its rims in the planes that it ends in, and one from a seed on each component of
/// its landmarks that the fronts before have not reached.
/// @throws Cancelled
PatchMesh growFront(const Landmarks& landmarks, const SplineField& field, const GuidanceField& size,
                    const EndPlanes& ends, const CutAway& away, SurfaceBorder border,
                    const Progress& progress);

/// Fills the part of a plane inside closed loops of points in it (the part to their left) with
/// triangles of the wanted size: a cap. The loops are vertices of `out`, in `loopPoints` with their
/// wanted lengths.
void fillCap(PatchMesh& out, const std::vector<std::vector<std::uint32_t>>& loops, int plane,
             const std::vector<FrontPoint>& loopPoints, const SplineField& field,
             const GuidanceField& size, const EndPlanes& ends, const Progress& progress);

/// Caps for the rims that clipReference() left at the sections of cuts. @throws Cancelled
void capCuts(PatchMesh& mesh, std::size_t cuts, const SplineField& field, const GuidanceField& size,
             const EndPlanes& ends, const Progress& progress = {});

}  // namespace angiomesh

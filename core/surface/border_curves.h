// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/surface/front_surface.h"
#include "core/surface/patch_mesh.h"

namespace angiomesh {

/// Outward unit normal of border plane a (see PatchMesh), LPS.
Eigen::Vector3d borderNormal(const Geometry& grid, int plane);

/// The border planes (bits 0..5) that a point lies in, within 1e-6 voxel.
std::uint8_t borderPlanes(const Geometry& grid, const Eigen::Vector3d& pointLps);

/// The curves on the border of the volume that fronts start from.
struct BorderCurves {
  std::vector<FrontPoint> points;   ///< with the normals of phi
  std::vector<std::uint8_t> place;  ///< as PatchMesh::place
  using Loop = std::vector<std::uint32_t>;
  std::vector<Loop> rims;                 ///< closed, the wall to the left seen from outside
  std::array<std::vector<Loop>, 6> caps;  ///< per border plane: closed, the cap to the left
};

/// Rims: where phi = 0 meets the border planes (traceBorder()), divided evenly by the wanted edge
/// length, which also follows the curve's own curvature (chordAngle = edge length times curvature)
/// and the distance to the curves' other parts in the same plane. With `caps` also the edges of the
/// volume inside phi, and the loops around each cap.
BorderCurves borderCurves(const SplineField& field, const GuidanceField& size, double chordAngle,
                          bool caps);

}  // namespace angiomesh

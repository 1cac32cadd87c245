// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"
#include "core/openings/port.h"

namespace angiomesh {

/// What the vertices of a finished mesh may do while it is smoothed. A cap is a patch, or a plane
/// half a voxel outside the grid of phi; an open rim lies in the outermost plane of voxel centres,
/// or at a port: their vertices stay in these planes. A rim in no known plane stays the line that
/// it is.
struct WallPlaces {
  /// Patches, `ports` and `phi` (may be null) tell where caps and open rims lie; `frozen` vertices
  /// stay in place.
  WallPlaces(const TriMesh& mesh, const SplineField* phi, const std::vector<Port>& ports,
             const std::vector<char>& frozen);

  /// The mesh, each vertex with its place and each triangle with its cap; planes are numbered as
  /// EndPlanes numbers cuts.
  PatchMesh mesh;
  /// Their outward normals; 0 of a line.
  std::vector<Eigen::Vector3d> planes;
  std::vector<char> fixed;    ///< per vertex: stays in place
  std::vector<char> offWall;  ///< per vertex: of a cap or a line, with no offset from the wall
};

}  // namespace angiomesh

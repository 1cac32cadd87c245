// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/mesh/tri_mesh.h"
#include "render/marks/port_drag.h"

class vtkRenderer;

namespace angiomesh {

/// The line of sight through a display position (pixels from the lower left corner).
ViewRay viewRay(vtkRenderer* renderer, double displayX, double displayY);

/// Display position of a point, pixels.
Eigen::Vector2d displayOf(vtkRenderer* renderer, const Eigen::Vector3d& point);

/// The length at a point that looks one pixel long.
double mmPerPixelAt(vtkRenderer* renderer, const Eigen::Vector3d& point);

/// Of a point from a segment, on the screen.
double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b);

struct SurfaceHit {
  Eigen::Vector3d place{0.0, 0.0, 0.0};  ///< mm LPS
  std::size_t triangle = 0;
};
/// Where a line of sight first meets a mesh, from either side.
std::optional<SurfaceHit> firstHit(const TriMesh& mesh, const ViewRay& ray);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/remesh/remesh_ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh {

ZeroSetGround::ZeroSetGround(const SplineField& field, const EdgeSize& size, const EndPlanes& ends)
    : field_(field),
      size_(size),
      ends_(ends),
      voxel_(field.geometry().voxelMm()),
      toIndex_(field.geometry().physicalToIndexMatrix()) {
  const Geometry& g = field.geometry();
  for (int axis = 0; axis < 3; ++axis) last_[axis] = g.size[static_cast<std::size_t>(axis)] - 1;
}

Eigen::Vector3d RemeshGround::along(const Place& place, const Vector3d& normal,
                                    const Vector3d& step) const {
  if (!place.wall) return inPlanes(place, step);
  const int planes = place.planes();
  if (planes == 0) return step - step.dot(normal) * normal;
  if (planes > 1) return Vector3d::Zero();
  const Vector3d& plane = planeNormal(place.firstPlane());
  if (plane.isZero()) return step;
  const Vector3d line = normal.cross(plane);
  const double square = line.squaredNorm();
  if (square < 1e-4) return Vector3d::Zero();
  return step.dot(line) / square * line;
}

bool ZeroSetGround::land(const Place& place, Vector3d& point, Vector3d& normal, int steps) const {
  constexpr double voxels = 1e-6;
  const Geometry& g = field_.geometry();
  const int held = place.planes();
  if (held > 0) ends_.snap(place, point);
  const Vector3d index = toIndex_ * (point - g.origin);
  constexpr double hair = 1e-6;
  if (!((index.array() >= -hair).all() && ((last_ - index).array() >= -hair).all())) return false;
  if (!place.wall) {
    ends_.forEachPlane(place, [&](int plane) { normal = planeNormal(plane); });
    return true;
  }
  for (int n = 0; n < steps; ++n) {
    const SplineField::Jet jet = field_.at(point);
    const double slope = jet.gradient.norm();
    if (!(slope > 1e-12) || !std::isfinite(slope)) return false;
    normal = jet.gradient / slope;
    if (held > 1) return true;
    Vector3d way = normal;
    if (held == 1) way = inPlanes(place, way);
    const double share = way.squaredNorm();
    if (share < 0.01) return false;
    const double distance = std::clamp(jet.value / slope / share, -0.5 * voxel_, 0.5 * voxel_);
    if (std::fabs(jet.value) <= voxels * voxel_ * slope) break;
    point -= distance * way;
  }
  if (held > 0) ends_.snap(place, point);
  return true;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/remesh_ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

namespace angiomesh {

RemeshGround::RemeshGround(const SplineField& field, const EdgeSize& size)
    : field_(field),
      size_(size),
      voxel_(field.geometry().voxelMm()),
      toIndex_(field.geometry().physicalToIndexMatrix()) {
  const Geometry& g = field.geometry();
  for (int axis = 0; axis < 3; ++axis) {
    last_[axis] = g.size[static_cast<std::size_t>(axis)] - 1;
    // A row of the matrix is normal to the other two axes and points along its own.
    const Vector3d n = toIndex_.row(axis).transpose().normalized();
    planeNormals_[static_cast<std::size_t>(2 * axis)] = -n;
    planeNormals_[static_cast<std::size_t>(2 * axis + 1)] = n;
  }
}

int RemeshGround::planes(std::uint8_t place) {
  return std::popcount(static_cast<unsigned>(place & PatchMesh::planeBits));
}

int RemeshGround::freedom(std::uint8_t place) {
  const int wall = (place & PatchMesh::wallBit) != 0 ? 1 : 0;
  return std::max(0, 3 - wall - planes(place));
}

Eigen::Vector3d RemeshGround::along(std::uint8_t place, const Vector3d& normal,
                                    const Vector3d& step) const {
  const bool wall = (place & PatchMesh::wallBit) != 0;
  if (wall && planes(place) == 0) return step - step.dot(normal) * normal;
  Vector3d first = Vector3d::Zero(), second = Vector3d::Zero();
  int n = 0;
  if (wall) {
    first = normal;
    ++n;
  }
  for (int a = 0; a < 6; ++a)
    if ((place >> a & 1) != 0) (n++ == 0 ? first : second) = planeNormal(a);
  if (n > 2) return Vector3d::Zero();
  if (n == 1) return step - step.dot(first) * first;
  const Vector3d line = first.cross(second);
  const double square = line.squaredNorm();
  if (square < 1e-4) return Vector3d::Zero();
  return step.dot(line) / square * line;
}

void RemeshGround::snap(std::uint8_t place, Vector3d& point) const {
  const Geometry& g = field_.geometry();
  for (int a = 0; a < 6; ++a) {
    if ((place >> a & 1) == 0) continue;
    const int axis = a / 2;
    const double wanted = a % 2 == 0 ? 0.0 : last_[axis];
    const double index = toIndex_.row(axis).dot(point - g.origin);
    point += (wanted - index) * g.spacing[axis] * g.direction.col(axis);
  }
}

bool RemeshGround::land(std::uint8_t place, Vector3d& point, Vector3d& normal, int steps,
                        double voxels) const {
  const Geometry& g = field_.geometry();
  const int held = planes(place);
  if (held > 0) snap(place, point);
  const Vector3d index = toIndex_ * (point - g.origin);
  constexpr double hair = 1e-6;
  if (!((index.array() >= -hair).all() && ((last_ - index).array() >= -hair).all())) return false;
  if ((place & PatchMesh::wallBit) == 0) {
    for (int a = 0; a < 6; ++a)
      if ((place >> a & 1) != 0) normal = planeNormal(a);
    return true;
  }
  for (int n = 0; n < steps; ++n) {
    const SplineField::Jet jet = field_.at(point);
    const double slope = jet.gradient.norm();
    if (!(slope > 1e-12) || !std::isfinite(slope)) return false;
    normal = jet.gradient / slope;
    if (held > 1) return true;
    Vector3d way = normal;
    if (held == 1)
      for (int a = 0; a < 6; ++a)
        if ((place >> a & 1) != 0) way -= way.dot(planeNormal(a)) * planeNormal(a);
    const double share = way.squaredNorm();
    if (share < 0.01) return false;
    const double distance = std::clamp(jet.value / slope / share, -0.5 * voxel_, 0.5 * voxel_);
    if (std::fabs(jet.value) <= voxels * voxel_ * slope) break;
    point -= distance * way;
  }
  if (held > 0) snap(place, point);
  return true;
}

}  // namespace angiomesh

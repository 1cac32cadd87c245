// SPDX-License-Identifier: BSD-3-Clause
#include "core/openings/end_planes.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

namespace angiomesh {

EndPlanes::EndPlanes(const Geometry& grid, std::vector<CutPlane> cuts)
    : grid_(grid), toIndex_(grid.physicalToIndexMatrix()), cuts_(std::move(cuts)) {
  for (int axis = 0; axis < 3; ++axis) {
    // A row of the matrix is normal to the other two axes and points along its own.
    const Vector3d n = toIndex_.row(axis).transpose().normalized();
    normals_.emplace_back(-n);
    normals_.push_back(n);
  }
  for (const CutPlane& cut : cuts_) normals_.push_back(cut.normalLps);
}

Place EndPlanes::borders(const Vector3d& pointLps) const {
  const Vector3d index = toIndex_ * (pointLps - grid_.origin);
  unsigned planes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(index[axis]) < 1e-6) planes |= 1U << (2 * axis);
    const double last = grid_.size[static_cast<std::size_t>(axis)] - 1;
    if (std::fabs(index[axis] - last) < 1e-6) planes |= 1U << (2 * axis + 1);
  }
  return {static_cast<std::uint8_t>(planes), false, 0};
}

EndPlanes::Vector3d EndPlanes::along(const Place& place, const Vector3d& step) const {
  std::array<Vector3d, 2> n;
  std::size_t count = 0;
  forEachPlane(place, [&](int plane) {
    if (count < n.size()) n[count] = normal(plane);
    ++count;
  });
  if (count == 0) return step;
  if (count == 1) return step - step.dot(n[0]) * n[0];
  const Vector3d line = n[0].cross(n[1]);
  const double square = line.squaredNorm();
  if (count > 2 || square < 1e-12) return Vector3d::Zero();
  return step.dot(line) / square * line;
}

void EndPlanes::snap(const Place& place, Vector3d& pointLps) const {
  forEachPlane(place, [&](int plane) {
    if (plane >= 6) {
      const CutPlane& cut = cuts_[static_cast<std::size_t>(plane) - 6];
      pointLps -= (pointLps - cut.pointLps).dot(cut.normalLps) * cut.normalLps;
      return;
    }
    const int axis = plane / 2;
    const double wanted = plane % 2 == 0 ? 0.0 : grid_.size[static_cast<std::size_t>(axis)] - 1.0;
    const double index = toIndex_.row(axis).dot(pointLps - grid_.origin);
    pointLps += (wanted - index) * grid_.spacing[axis] * grid_.direction.col(axis);
  });
}

}  // namespace angiomesh

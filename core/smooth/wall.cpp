// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/wall.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_edges.h"

namespace angiomesh {

Wall::Sample ZeroSetWall::at(const Eigen::Vector3d& pointLps) const {
  const Eigen::Vector3d index = toIndex_ * (pointLps - phi_.geometry().origin);
  SplineField::Jet jet = phi_.atIndex(index);
  for (int axis = 0; axis < 3; ++axis) {
    const double last = phi_.geometry().size[static_cast<std::size_t>(axis)] - 1;
    if (index[axis] < 0.0 || index[axis] > last) jet.gradient[axis] = 0.0;
  }
  const Eigen::Vector3d gradient = toIndex_.transpose() * jet.gradient;
  const double slope = gradient.norm();
  if (!(slope > 0.0) || !std::isfinite(slope)) return {};
  // Where phi flattens, one step must not leave the neighbourhood.
  const double reach = 0.5 * unitMm();
  return {gradient / slope, std::clamp(jet.value / slope, -reach, reach)};
}

MeshWall::MeshWall(const TriMesh& mesh, double boundUnits, const Progress& progress)
    : mesh_(mesh), tree_(mesh, progress), normals_(vertexNormals(mesh)) {
  double sum = 0.0;
  std::size_t count = 0;
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i), ++count) {
    sum += (mesh.points[sides[i].high] - mesh.points[sides[i].low]).norm();
  }
  if (count > 0) unitMm_ = sum / static_cast<double>(count);
  bulgeMm_ = 0.5 * boundUnits * unitMm_;
}

Wall::Sample MeshWall::at(const Eigen::Vector3d& pointLps) const {
  const TriangleTree::Closest closest = tree_.closest(pointLps);
  const auto& t = mesh_.triangles[closest.triangle];
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double bulge = 0.0;
  for (int k = 0; k < 3; ++k)
    normal += closest.weights[k] * normals_[t[static_cast<std::size_t>(k)]];
  const double length = normal.norm();
  if (!(length > 0.1)) return {};
  normal /= length;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& n = normals_[t[k]];
    const double below = n.dot(mesh_.points[t[k]] - closest.point);
    bulge += 0.75 * closest.weights[static_cast<int>(k)] * below * n.dot(normal);
  }
  const Eigen::Vector3d away = pointLps - closest.point;
  const double side = away.dot(normal);
  const double distance = side < 0.0 ? -closest.distance : closest.distance;
  return {normal, distance - std::clamp(bulge, -bulgeMm_, bulgeMm_)};
}

}  // namespace angiomesh

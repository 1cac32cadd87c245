// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/coarse_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiomesh {

namespace {

/// Triangles per cell that a smooth surface goes through, measured on vessel trees.
constexpr double kTrianglesPerCell = 3.5;
constexpr double kMostExcess = 1.5;
constexpr int kMostAgain = 3;

/// Vertices by the cell that they lie in and the octant of their normal.
std::vector<std::pair<std::uint64_t, std::uint32_t>> keysOf(const TriMesh& mesh, double cellMm) {
  const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh);
  Eigen::Vector3d low = mesh.points.front();
  for (const Eigen::Vector3d& point : mesh.points) low = low.cwiseMin(point);
  constexpr double most = (1 << 20) - 1;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(mesh.points.size());
  for (std::size_t v = 0; v < keys.size(); ++v) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::min((mesh.points[v][axis] - low[axis]) / cellMm, most);
      key = (key << 21) | (static_cast<std::uint64_t>(cell) << 1) |
            static_cast<std::uint64_t>(normals[v][axis] < 0.0);
    }
    keys[v] = {key, static_cast<std::uint32_t>(v)};
  }
  return keys;
}

/// The vertex that each vertex becomes; the points of those are their means.
std::vector<std::uint32_t> clusters(const TriMesh& mesh, double cellMm,
                                    std::vector<Eigen::Vector3d>& points) {
  auto keys = keysOf(mesh, cellMm);
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> cluster(keys.size());
  double members = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i].first != keys[i - 1].first) {
      points.emplace_back(Eigen::Vector3d::Zero());
      members = 0.0;
    }
    members += 1.0;
    points.back() += (mesh.points[keys[i].second] - points.back()) / members;
    cluster[keys[i].second] = static_cast<std::uint32_t>(points.size() - 1);
  }
  return cluster;
}

CoarseMesh clustered(const TriMesh& mesh, double cellMm) {
  CoarseMesh coarse;
  const std::vector<std::uint32_t> cluster = clusters(mesh, cellMm, coarse.mesh.points);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const std::array<std::uint32_t, 3> joined{cluster[t[0]], cluster[t[1]], cluster[t[2]]};
    if (repeatsVertex(joined)) continue;
    coarse.mesh.triangles.push_back(joined);
    coarse.from.push_back(static_cast<std::uint32_t>(i));
    if (!mesh.patch.empty()) coarse.mesh.patch.push_back(mesh.patch[i]);
  }
  return coarse;
}

}  // namespace

CoarseMesh coarseMesh(const TriMesh& mesh, std::size_t triangles) {
  const double area = surfaceAreaMm2(mesh);
  if (!(area > 0.0) || triangles == 0) return {};
  const auto wanted = static_cast<double>(triangles);
  double cellMm = std::sqrt(kTrianglesPerCell * area / wanted);
  CoarseMesh coarse = clustered(mesh, cellMm);
  // Of vessels thinner than a cell there is one triangle after the other, however large it is.
  for (int again = 0; again < kMostAgain; ++again) {
    const double excess = static_cast<double>(coarse.mesh.triangles.size()) / wanted;
    if (excess < kMostExcess) break;
    cellMm *= excess;
    coarse = clustered(mesh, cellMm);
  }
  return coarse;
}

}  // namespace angiomesh

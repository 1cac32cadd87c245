// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_merge.h"

#include <limits>
#include <numeric>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/outward.h"
#include "core/mesh/point_grid.h"
#include "io/mesh/point_merger.h"

namespace angiomesh {
namespace {

std::vector<bool> pointsAtOpenEdges(const TriMesh& mesh) {
  std::vector<bool> open(mesh.points.size(), false);
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    if (end == i + 1) open[sides[i].low] = open[sides[i].high] = true;
  }
  return open;
}

/// Leaves out the points that `renumbered` gives to others.
void renumber(TriMesh& mesh, const std::vector<std::uint32_t>& renumbered) {
  std::vector<std::uint32_t> place(mesh.points.size());
  std::vector<Eigen::Vector3d> points;
  for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
    if (renumbered[p] != p) continue;
    place[p] = static_cast<std::uint32_t>(points.size());
    points.push_back(mesh.points[p]);
  }
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = place[renumbered[corner]];
  mesh.points = std::move(points);
}

struct OpenPairs {
  std::vector<std::uint32_t> renumbered;  ///< per point, itself or the one that it becomes
  std::size_t count = 0;                  ///< of those that become another one
};

/// See mergeOpenPoints(); none where the distance is out of all proportion.
OpenPairs findOpenPairs(const TriMesh& mesh, double distanceMm) {
  // The grid has no cells of other sizes, and could not number them farther out.
  constexpr double mostDistances = 1e9, leastMm = 1e-12, mostMm = 1e12;
  OpenPairs pairs;
  if (!(distanceMm > leastMm && distanceMm < mostMm)) return pairs;
  for (const Eigen::Vector3d& point : mesh.points)
    if (!(point.cwiseAbs().maxCoeff() < mostDistances * distanceMm)) return pairs;
  const std::vector<bool> open = pointsAtOpenEdges(mesh);
  std::vector<std::uint32_t>& renumbered = pairs.renumbered;
  renumbered.resize(mesh.points.size());
  std::iota(renumbered.begin(), renumbered.end(), 0U);
  PointGrid kept;
  for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
    if (!open[p]) continue;
    const Eigen::Vector3d& point = mesh.points[p];
    double nearest = std::numeric_limits<double>::infinity();
    kept.forEachNear(point, distanceMm, 0.0, [&](std::uint32_t other) {
      const double away = (mesh.points[other] - point).norm();
      if (away > nearest || (away == nearest && other > renumbered[p])) return;
      nearest = away;
      renumbered[p] = other;
    });
    if (renumbered[p] == p)
      kept.insert(p, point, distanceMm);
    else
      ++pairs.count;
  }
  return pairs;
}

}  // namespace

std::size_t mergeEqualPoints(TriMesh& mesh) {
  std::vector<Eigen::Vector3d> points;
  PointMerger merger(points);
  std::vector<std::uint32_t> number;
  number.reserve(mesh.points.size());
  for (const Eigen::Vector3d& p : mesh.points) number.push_back(merger.add(p.x(), p.y(), p.z()));
  const std::size_t gone = mesh.points.size() - points.size();
  if (gone == 0 || isClosed(mesh)) return 0;
  mesh.points = std::move(points);
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = number[corner];
  return gone;
}

OpenMerge mergeOpenPoints(TriMesh& mesh, double distanceMm) {
  const OpenPairs pairs = findOpenPairs(mesh, distanceMm);
  const std::vector<std::uint32_t>& renumbered = pairs.renumbered;
  OpenMerge merge;
  merge.points = pairs.count;
  if (merge.points == 0) return merge;
  TriMesh whole;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const bool had = a != b && b != c && c != a;
    const std::uint32_t x = renumbered[a], y = renumbered[b], z = renumbered[c];
    if (had && (x == y || y == z || z == x)) {
      ++merge.triangles;
      continue;
    }
    whole.triangles.push_back(mesh.triangles[t]);
    if (!mesh.patch.empty()) whole.patch.push_back(mesh.patch[t]);
  }
  mesh.triangles = std::move(whole.triangles);
  mesh.patch = std::move(whole.patch);
  renumber(mesh, renumbered);
  return merge;
}

std::size_t openPointsNear(const TriMesh& mesh, double distanceMm) {
  return findOpenPairs(mesh, distanceMm).count;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/wall_accuracy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/mesh/triangle_shape.h"
#include "core/quality/local_wall.h"
#include "core/quality/wall_triangles.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kBorderVoxels = 1.25;
constexpr double kPlaneStep = 0.05;  // voxels, of the planes across a throat
constexpr std::size_t kBlock = 256;

/// What is known of a vertex or triangle that counts.
struct Place {
  bool counts = false;
  double distance = 0.0, angle = 0.0, curvatureError = -1.0, radius = 0.0;
};

/// Of the places whose radius is in [from, to), mm.
WallAgreement summarise(const std::vector<Place>& vertices, const std::vector<Place>& triangles,
                        double from, double to) {
  const auto in = [&](const Place& p) { return p.counts && p.radius >= from && p.radius < to; };
  std::vector<double> distances, sizes, angles, errors;
  for (const Place& p : vertices) {
    if (!in(p)) continue;
    distances.push_back(p.distance);
    sizes.push_back(std::fabs(p.distance));
    if (p.curvatureError >= 0.0) errors.push_back(p.curvatureError);
  }
  for (const Place& p : triangles)
    if (in(p)) angles.push_back(p.angle);
  WallAgreement out;
  out.vertices = distances.size();
  out.triangles = angles.size();
  if (!distances.empty()) {
    out.meanMm = meanOf(distances);
    double square = 0.0;
    for (const double d : distances) square += (d - out.meanMm) * (d - out.meanMm);
    out.spreadMm = std::sqrt(square / static_cast<double>(distances.size()));
    out.distance95Mm = percentile(sizes, 0.95);
  }
  if (!angles.empty()) {
    out.normalMeanDeg = meanOf(angles);
    out.normal95Deg = percentile(angles, 0.95);
  }
  if (!errors.empty()) out.curvatureErrorMedian = percentile(errors, 0.5);
  return out;
}

/// The foot of a point where it counts.
std::optional<WallFoot> footThatCounts(const Vector3d& point, const WallTruth& truth) {
  if (!truth.grid().holds(point, -kBorderVoxels)) return std::nullopt;
  const WallFoot foot = truth.footOf(point);
  if (truth.nearBranching(foot.point)) return std::nullopt;
  return foot;
}

std::vector<Place> measureVertices(const TriMesh& mesh, const std::vector<char>& wall,
                                   const WallTruth& truth, const Progress& progress) {
  std::vector<char> capped(mesh.points.size(), 0);
  for (std::size_t t = 0; t < wall.size(); ++t)
    if (wall[t] == 0)
      for (const std::uint32_t v : mesh.triangles[t]) capped[v] = 1;
  const MeshRings rings(mesh, wall);
  std::vector<Place> places(mesh.points.size());
  parallelFor(0, places.size(), kBlock, [&](std::size_t first, std::size_t last) {
    progress.check();
    std::vector<char> marks(mesh.points.size(), 0);
    std::vector<std::uint32_t> found;
    for (std::size_t n = first; n < last; ++n) {
      const auto v = static_cast<std::uint32_t>(n);
      if (capped[n] != 0 || rings.trianglesAt(v).empty()) continue;
      const auto foot = footThatCounts(mesh.points[n], truth);
      if (!foot) continue;
      Place& place = places[n];
      place.counts = true;
      place.distance = foot->signedDistanceMm;
      place.radius = truth.radiusAt(foot->point);
      rings.around(v, 0.0, 0, 2, marks, found);
      const auto fitted = LocalWall::fit(mesh, found, rings.normalAt(v), true);
      if (!fitted || !(place.radius > 0.0)) continue;
      const double curvature = truth.curvatureAt(*foot).mean();
      place.curvatureError = std::fabs(fitted->meanCurvature() - curvature) /
                             std::max(std::fabs(curvature), 0.25 / place.radius);
    }
  });
  return places;
}

std::vector<Place> measureTriangles(const TriMesh& mesh, const std::vector<char>& wall,
                                    const WallTruth& truth, const Progress& progress) {
  std::vector<Place> places(mesh.triangles.size());
  parallelForEach(places.size(), kBlock, progress, [&](std::size_t t) {
    if (wall[t] == 0) return;
    const auto& [a, b, c] = mesh.triangles[t];
    const Vector3d normal =
        (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    if (!(normal.norm() > 0.0)) return;
    const auto foot =
        footThatCounts((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0, truth);
    if (!foot) return;
    places[t].counts = true;
    places[t].angle = angleDegrees(normal.cross(foot->normal).norm(), normal.dot(foot->normal));
    places[t].radius = truth.radiusAt(foot->point);
  });
  return places;
}

}  // namespace

WallAccuracy wallAccuracy(const TriMesh& mesh, const WallTruth& truth, const Progress& progress) {
  checkMesh(mesh);
  const std::vector<char> wall = wallTriangles(mesh, truth.grid());
  const std::vector<Place> vertices = measureVertices(mesh, wall, truth, progress.sub(0.0, 0.5));
  progress.report(0.5);
  const std::vector<Place> triangles = measureTriangles(mesh, wall, truth, progress);
  const double voxel = truth.grid().voxelMm();
  WallAccuracy out;
  out.all = summarise(vertices, triangles, -1.0, 1e9 * voxel);
  for (std::size_t n = 0; n < out.byRadius.size(); ++n)  // a radius of 1.3 may come out below it
    out.byRadius[n] = summarise(vertices, triangles, (kRadiusClasses[n] - 1e-6) * voxel,
                                (kRadiusClasses[n + 1] - 1e-6) * voxel);
  std::vector<char> used(mesh.points.size(), 0);
  for (std::size_t t = 0; t < wall.size(); ++t)
    if (wall[t] != 0)
      for (const std::uint32_t v : mesh.triangles[t]) used[v] = 1;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] != 0 && !vertices[v].counts) ++out.leftOut;
  if (truth.throat())
    if (const auto found = leastDiameter(mesh, *truth.throat(), voxel))
      out.stenosis = StenosisDiameter{2.0 * truth.throat()->radiusMm, *found};
  progress.report(1.0);
  return out;
}

std::optional<double> leastDiameter(const TriMesh& mesh, const Throat& throat, double voxelMm) {
  const double reach = 0.5 * throat.halfLengthMm;
  const double step = kPlaneStep * voxelMm;
  const auto half = static_cast<int>(std::floor(reach / step));
  std::vector<double> areas(static_cast<std::size_t>(2 * half + 1), 0.0);
  bool any = false;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector3d, 3> p;
    std::array<double, 3> height{};
    bool near = true;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = mesh.points[triangle[i]] - throat.centre;
      height[i] = p[i].dot(throat.axis);
      near = near && (p[i] - height[i] * throat.axis).norm() < throat.halfLengthMm;
    }
    if (!near) continue;
    const auto [low, high] = std::minmax({height[0], height[1], height[2]});
    const int first = std::max(-half, static_cast<int>(std::ceil(low / step)));
    const int last = std::min(half, static_cast<int>(std::floor(high / step)));
    const Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    for (int n = first; n <= last; ++n) {
      // A vertex in the plane counts as above it, so that every crossing is met once.
      std::array<Vector3d, 2> ends;
      std::size_t count = 0;
      for (std::size_t i = 0; i < 3 && count < 2; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double a = height[i] - n * step;
        const double b = height[j] - n * step;
        if ((a >= 0.0) == (b >= 0.0)) continue;
        ends[count++] = p[i] + a / (a - b) * (p[j] - p[i]);
      }
      if (count < 2) continue;
      // Counter-clockwise around the axis: the outside to the right.
      const double sign = throat.axis.cross(normal).dot(ends[1] - ends[0]) > 0.0 ? 0.5 : -0.5;
      areas[static_cast<std::size_t>(n + half)] += sign * ends[0].cross(ends[1]).dot(throat.axis);
      any = true;
    }
  }
  if (!any) return std::nullopt;
  const double least = std::max(0.0, *std::min_element(areas.begin(), areas.end()));
  return 2.0 * std::sqrt(least / std::numbers::pi);
}

}  // namespace angiomesh

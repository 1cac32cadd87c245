// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/mesh_quality.h"
#include "core/mesh/mesh_faults.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/self_intersection.h"
#include "core/mesh/triangle_intersection.h"
#include "core/mesh/triangle_shape.h"
#include "core/mesh/triangle_tree.h"
#include "core/quality/wall_triangles.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 4096;
constexpr std::size_t listedPairs = 1000;

struct ComponentCount {
  std::size_t fans = 0, edges = 0, faces = 0, loops = 0;
};

// Boundary loops by component: two boundary edges follow one another when they end in one fan.
void countLoops(const TriMesh& mesh, const std::vector<EdgeSide>& sides, VertexFans& fans,
                const MeshComponents& components, std::vector<ComponentCount>& counts) {
  DisjointSets loops(3 * mesh.triangles.size());
  std::vector<std::uint32_t> ends;
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    if (edgeRunEnd(sides, i) != i + 1) continue;
    const std::uint32_t triangle = sides[i].triangle;
    const std::uint32_t a = fans.ofCorners.find(cornerAt(mesh, triangle, sides[i].low));
    loops.join(a, fans.ofCorners.find(cornerAt(mesh, triangle, sides[i].high)));
    ends.push_back(a);
  }
  std::set<std::uint32_t> roots;
  for (const std::uint32_t end : ends) {
    const std::uint32_t root = loops.find(end);
    if (roots.insert(root).second) ++counts[components.label[root / 3]].loops;
  }
}

void countTopology(const TriMesh& mesh, MeshQuality& q, const Progress& progress) {
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  progress.report(0.05);
  const MeshComponents components = meshComponents(mesh, sides);
  progress.report(0.1);
  std::vector<ComponentCount> counts(components.count);
  VertexFans fans = vertexFans(mesh, sides);
  progress.report(0.15);

  std::size_t edges = 0;
  bool consistent = true;
  for (std::size_t i = 0; i < sides.size(); ++edges) {
    const std::size_t end = edgeRunEnd(sides, i);
    if (end - i == 1) ++q.boundaryEdges;
    if (end - i > 2) ++q.nonManifoldEdges;
    consistent =
        consistent && end - i <= 2 && (end - i == 1 || sides[i].forward != sides[i + 1].forward);
    ++counts[components.label[sides[i].triangle]].edges;
    i = end;
  }
  std::vector<char> used(mesh.points.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const auto& t = mesh.triangles[corner / 3];
    if (repeatsVertex(t)) continue;
    used[t[corner % 3]] = 1;
    if (fans.ofCorners.find(corner) == corner) ++counts[components.label[corner / 3]].fans;
    if (corner % 3 == 0) ++counts[components.label[corner / 3]].faces;
  }
  countLoops(mesh, sides, fans, components, counts);

  std::size_t faces = 0;
  for (const ComponentCount& c : counts) {
    if (c.faces == 0) continue;
    ++q.components;
    faces += c.faces;
    q.boundaryLoops += c.loops;
    const long euler =
        static_cast<long>(c.fans) - static_cast<long>(c.edges) + static_cast<long>(c.faces);
    q.genus += static_cast<int>(std::max(0L, (2 - euler - static_cast<long>(c.loops)) / 2));
  }
  q.nonManifoldVertices =
      static_cast<std::size_t>(std::count(fans.several.begin(), fans.several.end(), 1));
  q.euler = static_cast<int>(std::count(used.begin(), used.end(), 1) - static_cast<long>(edges) +
                             static_cast<long>(faces));
  q.closed = faces > 0 && q.boundaryEdges == 0 && q.nonManifoldEdges == 0;
  q.areaMm2 = surfaceAreaMm2(mesh);
  q.volumeMm3 = q.closed ? enclosedVolumeMm3(mesh) : 0.0;
  q.oriented = faces > 0 && consistent && (!q.closed || q.volumeMm3 > 0.0);

  double sum = 0.0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i), ++counted) {
    const double length = (mesh.points[sides[i].high] - mesh.points[sides[i].low]).norm();
    q.edgeMinMm = counted == 0 ? length : std::min(q.edgeMinMm, length);
    q.edgeMaxMm = std::max(q.edgeMaxMm, length);
    sum += length;
  }
  q.edgeMeanMm = counted == 0 ? 0.0 : sum / static_cast<double>(counted);
}

// Per triangle: 1 where two of its sides border two other patches.
std::vector<char> inCorners(const TriMesh& mesh) {
  std::vector<char> corner(mesh.triangles.size(), 0);
  const auto onePatch = [&] {
    return std::all_of(mesh.patch.begin(), mesh.patch.end(),
                       [&](std::uint16_t patch) { return patch == mesh.patch.front(); });
  };
  if (mesh.patch.empty() || onePatch()) return corner;
  std::vector<std::uint32_t> first(corner.size(), 0);  // 1 + the other patch of a side
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    if (edgeRunEnd(sides, i) != i + 2) continue;
    const std::array<std::uint32_t, 2> both{sides[i].triangle, sides[i + 1].triangle};
    if (mesh.patch[both[0]] == mesh.patch[both[1]]) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t other = mesh.patch[both[1 - k]] + 1U;
      std::uint32_t& known = first[both[k]];
      if (known != 0 && known != other) corner[both[k]] = 1;
      known = other;
    }
  }
  return corner;
}

void measureCorners(const TriMesh& mesh, const std::vector<TriangleShape>& shapes, MeshQuality& q) {
  const std::vector<char> corner = inCorners(mesh);
  CornerShapes c;
  for (std::size_t t = 0; t < shapes.size(); ++t) {
    const bool in = corner[t] != 0;
    double& least = in ? c.minAngle : c.otherMinAngle;
    double& most = in ? c.maxAngle : c.otherMaxAngle;
    double& ratio = in ? c.radiusRatio : c.otherRadiusRatio;
    if (in) ++c.triangles;
    least = std::min(least, static_cast<double>(shapes[t].minAngle));
    most = std::max(most, static_cast<double>(shapes[t].maxAngle));
    ratio = std::min(ratio, static_cast<double>(shapes[t].radiusRatio));
  }
  if (c.triangles > 0) q.corners = c;
}

void measureShapes(const TriMesh& mesh, MeshQuality& q) {
  const std::vector<TriangleShape> shapes = shapesOf(mesh);
  if (shapes.empty()) return;
  std::vector<double> smallest, largest, ratios;
  for (auto* values : {&smallest, &largest, &ratios}) values->reserve(shapes.size());
  std::size_t below20 = 0, below30 = 0;
  for (const TriangleShape& s : shapes) {
    smallest.push_back(s.minAngle);
    largest.push_back(s.maxAngle);
    ratios.push_back(s.radiusRatio);
    q.skewnessMax = std::max(q.skewnessMax, s.skewness());
    q.skewnessMean += s.skewness() / static_cast<double>(shapes.size());
    q.aspectMax = std::max(q.aspectMax, s.aspectRatio);
    q.aspectMean += s.aspectRatio / static_cast<double>(shapes.size());
    if (s.minAngle < 20.0) ++below20;
    if (s.minAngle < 30.0) ++below30;
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (shapes[i].radiusRatio == 0.0 &&
        isDegenerate(cornersOf(mesh, static_cast<std::uint32_t>(i))))
      ++q.degenerateTriangles;
  measureCorners(mesh, shapes, q);
  q.minAngleMean = meanOf(smallest);
  q.radiusRatioMean = meanOf(ratios);
  q.minAngleMin = *std::min_element(smallest.begin(), smallest.end());
  q.minAngleP01 = percentile(smallest, 0.01);
  q.maxAngleMax = *std::max_element(largest.begin(), largest.end());
  q.maxAngleP99 = percentile(largest, 0.99);
  q.radiusRatioMin = *std::min_element(ratios.begin(), ratios.end());
  q.radiusRatioP01 = percentile(ratios, 0.01);
  const auto count = static_cast<double>(shapes.size());
  q.below20Percent = 100.0 * static_cast<double>(below20) / count;
  q.below30Percent = 100.0 * static_cast<double>(below30) / count;
}

// The largest curvature in magnitude of the level set of phi through a point, 1/mm.
double largestCurvature(const SplineField& phi, const Eigen::Vector3d& pointLps) {
  return principalCurvatures(phi.secondAt(pointLps)).maximal();
}

void measureNeighbours(const TriMesh& mesh, MeshQuality& q) {
  q.valences = measureValences(mesh);
  std::vector<double> gradations;
  for (const float ratio : sizeGradations(mesh))
    if (std::isfinite(ratio)) gradations.push_back(ratio);
  if (gradations.empty()) return;
  q.gradationMax = *std::max_element(gradations.begin(), gradations.end());
  q.gradationP99 = percentile(gradations, 0.99);
}

struct Deviations {
  std::optional<DeviationStats> distance;
  std::optional<CurvedDeviation> curved;
};

// Of the points where `counts` is not 0.
template <class PointAt>
Deviations deviation(const std::vector<char>& counts, PointAt pointAt, bool withCurvature,
                     const SplineField& phi, const Progress& progress) {
  const std::size_t count = counts.size();
  std::vector<double> moved(count, -1.0), curved(withCurvature ? count : 0, -1.0);
  parallelForEach(count, 512, progress, [&](std::size_t i) {
    if (counts[i] == 0) return;
    const Eigen::Vector3d start = pointAt(i);
    // Marching cubes goes half a voxel beyond the outermost voxel centres, where phi is not
    // known.
    if (!phi.geometry().holds(start, 1e-6)) return;
    Eigen::Vector3d onWall = start;
    // A point that finds no zero counts with the way it went.
    static_cast<void>(phi.projectToZero(onWall));
    moved[i] = (onWall - start).norm();
    if (withCurvature) curved[i] = moved[i] * largestCurvature(phi, onWall);
  });
  Deviations result;
  for (auto* values : {&moved, &curved})
    values->erase(std::remove(values->begin(), values->end(), -1.0), values->end());
  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  if (!moved.empty()) {
    const double mean = meanOf(moved);
    result.distance = {mean, percentile(moved, 0.99), largest(moved)};
  }
  if (!curved.empty()) {
    const double mean = meanOf(curved);
    result.curved = {mean, percentile(curved, 0.99), largest(curved)};
  }
  return result;
}

}  // namespace

MeshQuality measureQuality(const TriMesh& mesh, const SplineField* phi, const Progress& progress,
                           bool meetsNothing) {
  progress.report(0.0);
  checkMesh(mesh);
  MeshQuality q;
  q.vertices = mesh.points.size();
  q.triangles = mesh.triangles.size();
  countTopology(mesh, q, progress);
  progress.report(0.2);
  measureShapes(mesh, q);
  measureNeighbours(mesh, q);
  progress.report(0.25);
  q.gaps = gapFigures(measureGaps(mesh, progress.sub(0.25, 0.3)));
  std::vector<char> wall;
  if (phi != nullptr) wall = wallTriangles(mesh, phi->geometry());
  q.roughness = measureRoughness(mesh, wall, progress.sub(0.3, 0.4));
  if (!meetsNothing)
    q.intersectingPairs = selfIntersections(mesh, progress.sub(0.4, phi == nullptr ? 1.0 : 0.6));
  q.selfIntersections = q.intersectingPairs.size();
  if (q.intersectingPairs.size() > listedPairs) q.intersectingPairs.resize(listedPairs);
  if (phi != nullptr) {
    // Caps are no part of the zero set.
    std::vector<char> onWall(mesh.points.size(), 0);
    for (std::size_t t = 0; t < wall.size(); ++t)
      if (wall[t] != 0)
        for (const std::uint32_t v : mesh.triangles[t]) onWall[v] = 1;
    const auto vertexAt = [&](std::size_t i) { return mesh.points[i]; };
    q.vertexDeviation = deviation(onWall, vertexAt, false, *phi, progress).distance;
    progress.report(0.75);
    const Deviations centroids = deviation(
        wall,
        [&](std::size_t i) -> Eigen::Vector3d {
          const Triangle3 t = cornersOf(mesh, static_cast<std::uint32_t>(i));
          return (t[0] + t[1] + t[2]) / 3.0;
        },
        true, *phi, progress);
    q.centroidDeviation = centroids.distance;
    q.centroidTimesCurvature = centroids.curved;
  }
  progress.report(1.0);
  return q;
}

std::vector<TriangleShape> shapesOf(const TriMesh& mesh) {
  std::vector<TriangleShape> shapes(mesh.triangles.size());
  parallelForEach(shapes.size(), blockSize, [&](std::size_t i) {
    const Triangle3 t = cornersOf(mesh, static_cast<std::uint32_t>(i));
    if (!isDegenerate(t)) shapes[i] = triangleShape(t[0], t[1], t[2]);
  });
  return shapes;
}

std::string surfaceFault(const TriMesh& mesh, bool closed, const MeshQuality* known,
                         const Progress& progress) {
  if (known != nullptr && known->selfIntersections == 0 && known->nonManifoldEdges == 0 &&
      known->nonManifoldVertices == 0 && known->oriented && (known->closed || !closed))
    return {};
  const MeshFaults faults = findFaults(mesh, closed, progress);
  return faults.none() ? std::string() : "the surface " + faults.text();
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/sizing_check.h"

#include <Eigen/Geometry>
#include <vector>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"
#include "core/quality/wall_triangles.h"

namespace angiomesh {
namespace {

constexpr double shortest = 0.7, longest = 1.4;

}  // namespace

SizingCheck checkSizing(const TriMesh& mesh, const GuidanceField& wanted, const Geometry& grid,
                        const Progress& progress) {
  checkMesh(mesh);
  const std::vector<char> wall = wallTriangles(mesh, grid);
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  std::vector<EdgeSide> edges;
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    bool onWall = false;
    for (std::size_t j = i; j < edgeRunEnd(sides, i); ++j)
      onWall = onWall || wall[sides[j].triangle] != 0;
    if (onWall) edges.push_back(sides[i]);
  }

  std::vector<double> ratios(edges.size()), counts(wall.size(), 0.0);
  parallelForEach(edges.size(), 1024, progress, [&](std::size_t i) {
    const Eigen::Vector3d& a = mesh.points[edges[i].low];
    const Eigen::Vector3d& b = mesh.points[edges[i].high];
    ratios[i] = (b - a).norm() / wanted.at(0.5 * (a + b));
  });
  parallelFor(0, wall.size(), 1024, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t t = first; t < last; ++t) {
      if (wall[t] == 0) continue;
      const Eigen::Vector3d& a = mesh.points[mesh.triangles[t][0]];
      const Eigen::Vector3d& b = mesh.points[mesh.triangles[t][1]];
      const Eigen::Vector3d& c = mesh.points[mesh.triangles[t][2]];
      counts[t] = evenTriangles(0.5 * (b - a).cross(c - a).norm(), wanted.at((a + b + c) / 3.0));
    }
  });

  SizingCheck check;
  std::size_t inRange = 0;
  for (const double ratio : ratios) {
    check.edgeRatioMean += ratio;
    if (ratio >= shortest && ratio <= longest) ++inRange;
  }
  if (!ratios.empty()) {
    check.edgeRatioMean /= static_cast<double>(ratios.size());
    check.edgesInRangePercent =
        100.0 * static_cast<double>(inRange) / static_cast<double>(ratios.size());
  }
  for (std::size_t t = 0; t < wall.size(); ++t) {
    check.triangles += wall[t] != 0 ? 1 : 0;
    check.wantedTriangles += counts[t];
  }
  progress.report(1.0);
  return check;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/wall_gaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/statistics.h"

namespace angiomesh {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

std::vector<double> known(const std::vector<float>& values) {
  std::vector<double> list;
  list.reserve(values.size());
  for (const float value : values)
    if (!std::isnan(value)) list.push_back(value);
  return list;
}

}  // namespace

WallGaps measureGaps(const TriMesh& mesh, const Progress& progress) {
  const TriangleTree tree(mesh, progress.sub(0.0, 0.3));
  return measureGaps(mesh, tree, progress.sub(0.3, 1.0));
}

WallGaps measureGaps(const TriMesh& mesh, const TriangleTree& tree, const Progress& progress) {
  WallGaps gaps;
  gaps.gapEdges.assign(mesh.triangles.size(), kNone);
  gaps.thicknessMm.assign(mesh.triangles.size(), kNone);
  parallelForEach(mesh.triangles.size(), 1024, progress, [&](std::size_t t) {
    if (!mesh.patch.empty() && mesh.patch[t] != 0) return;
    const auto [a, b, c] = cornersOf(mesh, static_cast<std::uint32_t>(t));
    const Eigen::Vector3d twice = (b - a).cross(c - a);
    const double area = twice.norm();
    if (!(area > 0.0)) return;
    const Eigen::Vector3d normal = twice / area;
    const Eigen::Vector3d centre = (a + b + c) / 3.0;
    const double edge = ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3.0;
    TriangleTree::Stop stop;
    stop.notAt = mesh.triangles[t];
    const double through = tree.firstStop(centre, -normal, stop);
    if (std::isfinite(through)) gaps.thicknessMm[t] = static_cast<float>(through);
    stop.entering = true;
    stop.most = gapReach * edge;
    const double gap = tree.firstStop(centre, normal, stop);
    if (std::isfinite(gap)) gaps.gapEdges[t] = static_cast<float>(gap / edge);
  });
  progress.report(1.0);
  return gaps;
}

GapFigures gapFigures(const WallGaps& gaps) {
  GapFigures figures;
  const std::vector<double> widths = known(gaps.gapEdges);
  if (!widths.empty()) {
    figures.leastGapEdges = *std::min_element(widths.begin(), widths.end());
    figures.narrowPercent = 100.0 *
                            static_cast<double>(std::count_if(widths.begin(), widths.end(),
                                                              [](double w) { return w < 1.0; })) /
                            static_cast<double>(gaps.gapEdges.size());
  }
  std::vector<double> through = known(gaps.thicknessMm);
  if (!through.empty()) {
    figures.leastThicknessMm = *std::min_element(through.begin(), through.end());
    figures.thickness1Mm = percentile(through, 0.01);
  }
  return figures;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/bridge_vessels.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/corrections/cheapest_ways.h"
#include "core/corrections/vessel_beside.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// Of a step where there is no vesselness, against one where it is largest.
constexpr double kDearest = 20.0;
/// Voxels around both places, and of their distance: how far the way may stray.
constexpr double kAroundVoxels = 8.0, kAroundShare = 0.35;
constexpr std::size_t kMostVoxels = 2'000'000;
/// Rounds of averaging with both neighbours, which take the stairs of the grid.
constexpr int kRounds = 8;

VesselBeside endAt(const Volume<float>& phi, const Vector3d& placeLps) {
  return requireVesselBeside(phi, placeLps, "bridge",
                             "give two places in vessels, or at most 3 voxels beside them");
}

/// Per mm: 1 inside phi < 0 and where the vesselness is largest.
Volume<float> costOf(const Volume<float>& image, const VesselnessParams& params,
                     const Volume<float>& phi, const VoxelBox& box, const Progress& progress) {
  Volume<float> v = vesselness(cropped(image, box), params, progress);
  const float most = std::max(valueRange(v)[1], 1e-6F);
  const Volume<float> inside = cropped(phi, box);
  const auto least = static_cast<float>(1.0 / kDearest);
  for (std::size_t i = 0; i < v.voxels.size(); ++i) {
    const float share = inside.voxels[i] < 0.0F ? 1.0F : std::max(v.voxels[i] / most, 0.0F);
    v.voxels[i] = (1.0F + least) / (share + least);
  }
  return v;
}

void smoothLine(std::vector<Vector3d>& points) {
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Vector3d> before = points;
    for (std::size_t n = 1; n + 1 < points.size(); ++n)
      points[n] = 0.25 * (before[n - 1] + 2.0 * before[n] + before[n + 1]);
  }
}

/// At each point of a line, evenly along it.
std::vector<double> evenly(const std::vector<Vector3d>& points, double first, double last) {
  std::vector<double> along(points.size(), 0.0);
  for (std::size_t n = 1; n < points.size(); ++n)
    along[n] = along[n - 1] + (points[n] - points[n - 1]).norm();
  const double length = std::max(along.back(), 1e-9);
  for (double& a : along) a = first + (last - first) * a / length;
  return along;
}

}  // namespace

Shape bridgeBetween(const Volume<float>* image, const VesselnessParams& params,
                    const Volume<float>& phi, const Vector3d& fromLps, const Vector3d& toLps,
                    const Progress& progress) {
  const Geometry& g = phi.geometry;
  const VesselBeside from = endAt(phi, fromLps), to = endAt(phi, toLps);
  std::vector<Vector3d> line{from.centreLps, to.centreLps};
  if (image != nullptr && from.middle != to.middle) {
    const double reach = kAroundVoxels * g.voxelMm() + kAroundShare * (line[1] - line[0]).norm();
    const VoxelBox box = *boxOf(g, line, reach);
    if (box.voxelCount() > kMostVoxels)
      throw InputError("the ends are too far apart", "bridge",
                       "choose ends that are nearer to each other, or add with a brush");
    const Volume<float> cost = costOf(*image, params, phi, box, progress);
    const VoxelBox first = VoxelBox{from.middle, to.middle}.seenFrom(box);
    const std::vector<Index3> way = cheapestWays(cost, first.low, progress).wayTo(first.high);
    line.assign(1, from.centreLps);
    for (std::size_t n = 1; n + 1 < way.size(); ++n)
      line.push_back(voxelCentre(cost.geometry, way[n]));
    line.push_back(to.centreLps);
    smoothLine(line);
  }
  const std::vector<double> radii = evenly(line, from.radiusMm, to.radiusMm);
  return tubeShape(g, line, radii);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/sensitivity/wall_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/statistics.h"
#include "core/contour/marching_cubes.h"
#include "core/field/wall_field.h"

namespace angiomesh {
namespace {

/// Working voxels: phi is clamped a little farther off.
constexpr double kLimitVoxels = 4.0;
/// A place so many radii off a centre line belongs to another branch.
constexpr double kFarRadii = 3.0;

/// The branch whose wall, as its radii tell, is nearest.
std::int32_t branchAt(const Skeleton& skeleton, const Eigen::Vector3d& place) {
  std::int32_t nearest = -1;
  double least = std::numeric_limits<double>::max();
  for (std::size_t b = 0; b < skeleton.branches.size(); ++b)
    for (const SkeletonPoint& point : skeleton.branches[b].points) {
      const double away = (place - point.pointLps).norm();
      if (away > kFarRadii * point.radiusMm) continue;
      const double off = std::fabs(away - point.radiusMm);
      if (off >= least) continue;
      least = off;
      nearest = static_cast<std::int32_t>(b);
    }
  return nearest;
}

void addVoxels(WallMoves& moves, const Volume<float>& phi, const Volume<float>& other) {
  std::size_t before = 0, after = 0, both = 0;
  for (std::size_t v = 0; v < phi.voxels.size(); ++v) {
    const bool was = phi.voxels[v] < 0.0F, is = other.voxels[v] < 0.0F;
    before += was ? 1 : 0;
    after += is ? 1 : 0;
    both += was && is ? 1 : 0;
  }
  if (before == 0) return;
  moves.volumePercent = 100.0 * (static_cast<double>(after) / static_cast<double>(before) - 1.0);
  moves.overlapPercent = 200.0 * static_cast<double>(both) / static_cast<double>(before + after);
}

}  // namespace

WallPlaces wallPlaces(const Volume<float>& phi, const Progress& progress) {
  WallPlaces places;
  places.wall = marchingCubes(phi, SurfaceBorder::Open, progress.sub(0.0, 0.2));
  places.skeleton = skeletonOf(phi, progress.sub(0.2, 0.9));
  places.branch.resize(places.wall.points.size());
  places.off.resize(places.wall.points.size());
  const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
  parallelForEach(places.branch.size(), 256, [&](std::size_t n) {
    places.branch[n] = branchAt(places.skeleton, places.wall.points[n]);
    places.off[n] = static_cast<float>(field.valueAt(places.wall.points[n]));
  });
  progress.report(1.0);
  return places;
}

WallMoves wallMoves(const WallPlaces& places, const Volume<float>& phi,
                    const Volume<float>& other) {
  WallMoves moves;
  const std::vector<Eigen::Vector3d>& points = places.wall.points;
  const auto limit = static_cast<float>(kLimitVoxels * phi.geometry.voxelMm());
  const SplineField field = wallField(other, SplineKind::InterpolatingBspline);
  moves.movedMm.resize(points.size());
  parallelForEach(points.size(), 1024, [&](std::size_t n) {
    const auto now = static_cast<float>(field.valueAt(points[n]));
    moves.movedMm[n] = std::clamp(places.off[n] - now, -limit, limit);
  });
  moves.branches.resize(places.skeleton.branches.size());
  std::vector<double> sizes;
  std::size_t lost = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const float moved = moves.movedMm[n];
    const bool gone = moved <= -limit;
    WallMoves::Branch* branch = places.branch[n] >= 0
                                    ? &moves.branches[static_cast<std::size_t>(places.branch[n])]
                                    : nullptr;
    if (branch != nullptr) {
      ++branch->places;
      (gone ? branch->lostPercent : branch->meanMm) += gone ? 1.0 : moved;
    }
    if (gone) {
      ++lost;
      continue;
    }
    moves.meanMm += moved;
    sizes.push_back(std::fabs(moved));
  }
  for (WallMoves::Branch& branch : moves.branches) {
    const double left = static_cast<double>(branch.places) - branch.lostPercent;
    if (left > 0.0) branch.meanMm /= left;
    if (branch.places > 0) branch.lostPercent *= 100.0 / static_cast<double>(branch.places);
  }
  if (!sizes.empty()) {
    const auto count = static_cast<double>(sizes.size());
    moves.meanMm /= count;
    for (const double size : sizes) moves.meanSizeMm += size / count;
    moves.p95Mm = percentile(sizes, 0.95);
  }
  if (!points.empty())
    moves.lostPercent = 100.0 * static_cast<double>(lost) / static_cast<double>(points.size());
  addVoxels(moves, phi, other);
  return moves;
}

}  // namespace angiomesh

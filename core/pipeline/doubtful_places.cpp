// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/doubtful_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/formatted.h"
#include "core/base/parallel.h"
#include "core/centreline/skeleton.h"
#include "core/image/voxels.h"
#include "core/pipeline/segments.h"
#include "core/topology/handles.h"

namespace angiomesh {

namespace {

constexpr double kNeckShare = 0.6;
constexpr double kNeckReach = 3.0;  // radii
constexpr float kMissedShare = 0.6F;
constexpr std::size_t kMissedVoxels = 20;
constexpr double kIslandShare = 0.02;

using Places = std::vector<DoubtfulPlace>;

Places holes(const Volume<float>& phi, const Progress& progress) {
  Places places;
  for (const Handle& handle : handlesOf(phi, progress)) {
    if (handle.kind == HandleKind::Loop) continue;
    const bool hole = handle.kind == HandleKind::Hole;
    places.push_back(
        {DoubtKind::Hole, hole ? handle.centreLps : handle.placeLps, 1.0 / handle.lengthMm,
         formatted(hole ? "A hole of %.3g mm around goes through the vessel."
                        : "A loop of %.3g mm closes through a place thinner than half a voxel.",
                   handle.lengthMm)});
  }
  return places;
}

/// The largest radius within reach of a point, before it or after it along the branch.
double thickestBeside(const SkeletonBranch& branch, std::size_t at, int step, double reachMm) {
  double most = 0.0, way = 0.0;
  const auto count = static_cast<std::ptrdiff_t>(branch.points.size());
  for (auto i = static_cast<std::ptrdiff_t>(at); i + step >= 0 && i + step < count; i += step) {
    const SkeletonPoint& here = branch.points[static_cast<std::size_t>(i)];
    const SkeletonPoint& next = branch.points[static_cast<std::size_t>(i + step)];
    way += (next.pointLps - here.pointLps).norm();
    if (way > reachMm) break;
    most = std::max(most, next.radiusMm);
  }
  return most;
}

/// The narrowest point of a stretch that is thin against both its sides.
void addNecks(const SkeletonBranch& branch, Places& places) {
  std::optional<DoubtfulPlace> narrowest;
  double least = 0.0;
  const auto end = [&] {
    if (narrowest) places.push_back(*std::exchange(narrowest, std::nullopt));
  };
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    const double radius = branch.points[i].radiusMm;
    // Of a thick vessel with a short narrow place: radii of the vessel, not of that place.
    const double reach = kNeckReach * std::max(radius, branch.meanRadiusMm);
    const double before = thickestBeside(branch, i, -1, reach);
    const double after = thickestBeside(branch, i, 1, reach);
    const double beside = std::min(before, after);
    if (!(radius < kNeckShare * beside)) {
      end();
      continue;
    }
    if (narrowest && radius >= least) continue;
    least = radius;
    narrowest = {DoubtKind::Neck, branch.points[i].pointLps, beside / std::max(radius, 1e-6),
                 formatted("The vessel is %.2g mm wide here, and %.2g and %.2g mm on either side.",
                           2.0 * radius, 2.0 * before, 2.0 * after)};
  }
  end();
}

Places necks(const Volume<float>& phi, const Progress& progress) {
  Places places;
  for (const SkeletonBranch& branch : skeletonOf(phi, progress).branches) addNecks(branch, places);
  return places;
}

Places missed(const Volume<float>& phi, const Volume<float>& v, const Thresholds& thresholds) {
  const auto least = kMissedShare * static_cast<float>(thresholds.b);
  const auto away = static_cast<float>(phi.geometry.voxelMm());
  Volume<std::uint8_t> found(phi.geometry);
  parallelForEach(found.voxels.size(), std::size_t{1} << 14, [&](std::size_t i) {
    found.voxels[i] = v.voxels[i] >= least && phi.voxels[i] > away ? 1 : 0;
  });
  const Components parts = connectedComponents(found);
  // Largest first: what is smaller than it has to be comes last.
  std::size_t count = 0;
  while (count < parts.sizes.size() && parts.sizes[count] >= kMissedVoxels) ++count;
  std::vector<std::size_t> best(count);
  std::vector<float> most(count, 0.0F);
  std::vector<double> sums(count, 0.0);
  for (std::size_t i = 0; i < found.voxels.size(); ++i) {
    const auto part = static_cast<std::size_t>(parts.labels.voxels[i]);
    if (part == 0 || part > count) continue;
    sums[part - 1] += static_cast<double>(v.voxels[i]);
    if (v.voxels[i] <= most[part - 1]) continue;
    most[part - 1] = v.voxels[i];
    best[part - 1] = i;
  }
  Places places;
  for (std::size_t n = 0; n < count; ++n)
    places.push_back(
        {DoubtKind::Missed, voxelCentre(phi.geometry, best[n]), sums[n],
         formatted("Vesselness up to %.2g in %zu voxels outside: a vessel may be missing "
                   "(b is %.2g).",
                   static_cast<double>(most[n]), parts.sizes[n], thresholds.b)});
  return places;
}

Places islands(const Volume<float>& phi) {
  const Components parts = connectedComponents(insideMask(phi));
  Places places;
  if (parts.sizes.empty()) return places;
  const std::vector<Eigen::Vector3d> inner = innerPoints(phi, parts);
  const double voxel = phi.geometry.voxelVolumeMm3();
  for (std::size_t n = 1; n < parts.sizes.size(); ++n) {
    const auto size = static_cast<double>(parts.sizes[n]);
    if (size >= kIslandShare * static_cast<double>(parts.sizes[0])) continue;
    places.push_back({DoubtKind::Island, inner[n], 1.0 / size,
                      formatted("A part of %.3g mm³ hangs on nothing.", size * voxel)});
  }
  return places;
}

void append(Places& all, Places places) {
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.weight > b.weight; });
  places.resize(std::min(places.size(), kMostDoubts));
  all.insert(all.end(), places.begin(), places.end());
}

}  // namespace

Places doubtfulPlaces(const Volume<float>& phi, const VesselnessResult* vesselness,
                      const Thresholds& thresholds, const Progress& progress) {
  Places all;
  append(all, holes(phi, progress.sub(0.0, 0.3)));
  append(all, necks(phi, progress.sub(0.3, 0.8)));
  progress.check();
  if (vesselness != nullptr && vesselness->multiScale &&
      vesselness->multiScale->geometry == phi.geometry)
    append(all, missed(phi, *vesselness->multiScale, thresholds));
  progress.check();
  append(all, islands(phi));
  return all;
}

}  // namespace angiomesh

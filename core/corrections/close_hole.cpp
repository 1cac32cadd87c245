// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/close_hole.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/image/growing_box.h"
#include "core/image/voxels.h"
#include "core/topology/close_handles.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLargestCavity = 100'000;
/// How far from the place a hole may lie, and what of the vessels around it is looked at, voxels.
constexpr int kNear = 12, kLook = 24;
/// Somebody has asked for it: the wall may be as wrong as phi tells.
constexpr double kDepthVoxels = 4.9;
constexpr std::size_t kWidest = 400;
constexpr double kLongestLoop = 1000.0;
/// Of a filled voxel: inside for sure.
constexpr float kFilledVoxels = 0.5F;

VoxelBox boxOfVoxels(const Geometry& g, const std::vector<std::size_t>& voxels) {
  GrowingBox box;
  for (const std::size_t v : voxels) box.add(g.indexOf(v));
  return *box.box();
}

/// The voxels of phi >= 0 joined by faces to the one at the place; nothing where they reach the
/// border or are too many, or the place is inside.
std::vector<std::size_t> cavityAt(const Volume<float>& phi, const Index3& place) {
  const Geometry& g = phi.geometry;
  const std::size_t start = g.offset(place[0], place[1], place[2]);
  if (phi.voxels[start] < 0.0F) return {};
  std::vector<std::size_t> set{start};
  Volume<std::uint8_t> seen(g);
  seen.voxels[start] = 1;
  for (std::size_t n = 0; n < set.size(); ++n) {
    const Index3 p = g.indexOf(set[n]);
    for (std::size_t a = 0; a < 3; ++a)
      if (p[a] == 0 || p[a] + 1 == g.size[a]) return {};
    forFaceNeighbours(g, set[n], [&](std::size_t next) {
      if (seen.voxels[next] != 0 || phi.voxels[next] < 0.0F) return;
      seen.voxels[next] = 1;
      set.push_back(next);
    });
    if (set.size() > kLargestCavity) return {};
  }
  return set;
}

/// Of the voxels that changed sides from `before` to `after` the connected ones nearest to a place.
std::vector<std::size_t> nearestChange(const Volume<float>& before, const Volume<float>& after,
                                       bool filled, const Vector3d& placeLps) {
  Volume<std::uint8_t> changed(before.geometry);
  for (std::size_t v = 0; v < before.voxels.size(); ++v) {
    const bool was = before.voxels[v] < 0.0F, is = after.voxels[v] < 0.0F;
    changed.voxels[v] = was != is && is == filled ? 1 : 0;
  }
  const Components parts = connectedComponents(changed);
  std::int32_t nearest = 0;
  double least = (kNear + 0.5) * before.geometry.voxelMm();
  for (std::size_t v = 0; v < changed.voxels.size(); ++v) {
    if (changed.voxels[v] == 0) continue;
    const double away = (voxelCentre(before.geometry, v) - placeLps).norm();
    if (away >= least) continue;
    least = away;
    nearest = parts.labels.voxels[v];
  }
  std::vector<std::size_t> voxels;
  if (nearest == 0) return voxels;
  for (std::size_t v = 0; v < changed.voxels.size(); ++v)
    if (parts.labels.voxels[v] == nearest) voxels.push_back(v);
  return voxels;
}

Index3 voxelAt(const Geometry& g, const Vector3d& placeLps, const char* what) {
  if (!g.holds(placeLps, 0.5))
    throw InputError(placeText(placeLps) + " lies outside the volume", what,
                     "give a place in mm LPS");
  Index3 p = nearestVoxel(g, placeLps);
  for (std::size_t a = 0; a < 3; ++a) p[a] = std::clamp(p[a], 0, g.size[a] - 1);
  return p;
}

/// Changes the handle of one kind that is nearest to a place.
std::optional<VoxelBox> closeNearest(Volume<float>& phi, const Vector3d& placeLps, bool fill,
                                     const Progress& progress) {
  const Geometry& g = phi.geometry;
  const int side = 2 * kLook + 1;
  const VoxelBox box = boxAround(g, placeLps, {side, side, side});
  const Volume<float> before = cropped(phi, box);
  Volume<float> after = before;
  HandleLimits limits;
  limits.depth = kDepthVoxels * g.voxelMm();
  limits.holeVoxels = fill ? kWidest : 0;
  limits.cutVoxels = fill ? 0 : kWidest;
  limits.loopVoxels = kLongestLoop;
  (void)closeSmallHandles(after, limits, nullptr, progress);
  const std::vector<std::size_t> voxels = nearestChange(before, after, fill, placeLps);
  if (voxels.empty()) return std::nullopt;
  const auto least = static_cast<float>(static_cast<double>(kFilledVoxels) * g.voxelMm());
  for (const std::size_t v : voxels) {
    const Index3 p = before.geometry.indexOf(v);
    phi.at(box.low[0] + p[0], box.low[1] + p[1], box.low[2] + p[2]) = fill ? -least : least;
  }
  VoxelBox changed = boxOfVoxels(before.geometry, voxels);
  for (std::size_t a = 0; a < 3; ++a) {
    changed.low[a] += box.low[a];
    changed.high[a] += box.low[a];
  }
  return changed;
}

}  // namespace

VoxelBox fillHole(Volume<float>& phi, const Vector3d& placeLps, const Progress& progress) {
  const Index3 place = voxelAt(phi.geometry, placeLps, "fill-hole");
  const std::vector<std::size_t> cavity = cavityAt(phi, place);
  if (!cavity.empty()) {
    const auto filled = static_cast<float>(-kFilledVoxels * phi.geometry.voxelMm());
    for (const std::size_t v : cavity) phi.voxels[v] = std::min(-phi.voxels[v], filled);
    return boxOfVoxels(phi.geometry, cavity);
  }
  if (const auto changed = closeNearest(phi, placeLps, true, progress)) return *changed;
  throw InputError("there is no hole or cavity at " + placeText(placeLps), "fill-hole",
                   "point into the hole, or add with a brush");
}

VoxelBox openLoop(Volume<float>& phi, const Vector3d& placeLps, const Progress& progress) {
  (void)voxelAt(phi.geometry, placeLps, "open-loop");
  if (const auto changed = closeNearest(phi, placeLps, false, progress)) return *changed;
  throw InputError("there is no loop near " + placeText(placeLps) + " that can be cut", "open-loop",
                   "point to where the loop is thinnest, or erase with a brush");
}

}  // namespace angiomesh

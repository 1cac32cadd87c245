// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/separate_vessels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/corrections/cheapest_ways.h"
#include "core/corrections/vessel_beside.h"
#include "core/distance/mask_distance.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// A gap of less could be stepped over from voxel to voxel.
constexpr double kHalfGapVoxels = 0.9;
/// Beyond both places, in their distance and in voxels.
constexpr double kAroundShare = 1.0, kAroundVoxels = 4.0;
constexpr std::size_t kMostVoxels = 2'000'000;
/// Per mm, where nothing speaks for a vessel, against the middle of one.
constexpr double kDearest = 400.0;

/// What speaks for the middle of a vessel, 0..1.
class Likeness {
 public:
  Likeness(const Volume<float>* image, float sign, const Volume<float>& phi, const VoxelBox& box,
           double radiusMm, const std::array<Index3, 2>& middles)
      : phi_(cropped(phi, box)), radius_(static_cast<float>(radiusMm)) {
    if (image == nullptr) return;
    image_ = cropped(*image, box);
    for (float& v : image_.voxels) v *= sign;
    bright_ = std::min(sign * image->at(middles[0][0], middles[0][1], middles[0][2]),
                       sign * image->at(middles[1][0], middles[1][1], middles[1][2]));
    dark_ = valueRange(image_)[0];
  }

  [[nodiscard]] float at(std::size_t voxel) const {
    const float deep = std::clamp(-phi_.voxels[voxel] / radius_, 0.0F, 1.0F);
    if (image_.voxels.empty() || !(bright_ > dark_)) return deep;
    return deep * std::clamp((image_.voxels[voxel] - dark_) / (bright_ - dark_), 0.0F, 1.0F);
  }

  [[nodiscard]] const Volume<float>& phi() const { return phi_; }

 private:
  Volume<float> phi_, image_;
  float radius_, bright_ = 0.0F, dark_ = 0.0F;
};

/// Gives all other voxels the value of the nearest one in a list, by steps over faces.
void spread(Volume<std::uint8_t>& values, std::vector<std::size_t> known) {
  Volume<std::uint8_t> has(values.geometry);
  for (const std::size_t v : known) has.voxels[v] = 1;
  for (std::size_t n = 0; n < known.size(); ++n)
    forFaceNeighbours(values.geometry, known[n], [&](std::size_t next) {
      if (has.voxels[next] != 0) return;
      has.voxels[next] = 1;
      values.voxels[next] = values.voxels[known[n]];
      known.push_back(next);
    });
}

}  // namespace

Shape gapBetween(const Volume<float>* image, float sign, const Volume<float>& phi,
                 const Vector3d& oneLps, const Vector3d& otherLps, const Progress& progress) {
  const Geometry& g = phi.geometry;
  const auto vesselOf = [&phi](const Vector3d& placeLps) {
    return requireVesselBeside(phi, placeLps, "separate",
                               "give a place in each of the two vessels");
  };
  const std::array vessels{vesselOf(oneLps), vesselOf(otherLps)};
  if (vessels[0].middle == vessels[1].middle)
    throw InputError("both places lie in one vessel", "separate",
                     "give a place in the middle of each of the two vessels");
  const std::vector<Vector3d> places{voxelCentre(g, vessels[0].middle),
                                     voxelCentre(g, vessels[1].middle)};
  const double between = (places[1] - places[0]).norm();
  const double radius = std::min(vessels[0].ballMm, vessels[1].ballMm);
  const double reach = kAroundShare * between + kAroundVoxels * g.voxelMm();
  const VoxelBox box = *boxOf(g, places, reach);
  if (box.voxelCount() > kMostVoxels)
    throw InputError("the places are too far apart", "separate",
                     "give places on both sides of where the vessels touch");
  const Likeness likeness(image, sign, phi, box, radius, {vessels[0].middle, vessels[1].middle});
  const VoxelBox starts = VoxelBox{vessels[0].middle, vessels[1].middle}.seenFrom(box);
  const Components parts = connectedComponents(insideMask(likeness.phi()));
  const auto partAt = [&](const Index3& p) { return parts.labels.at(p[0], p[1], p[2]); };
  const std::int32_t joined = partAt(starts.low);
  if (partAt(starts.high) != joined)
    throw InputError("the vessels do not touch between these places", "separate",
                     "give places on both sides of where they touch");
  Volume<float> cost(croppedGrid(g, box));
  constexpr auto least = static_cast<float>(1.0 / kDearest);
  for (std::size_t v = 0; v < cost.voxels.size(); ++v) {
    const float share = likeness.at(v);
    cost.voxels[v] = parts.labels.voxels[v] == joined ? (1.0F + least) / (share * share + least)
                                                      : std::numeric_limits<float>::infinity();
  }
  const Volume<float> one = cheapestWays(cost, starts.low, progress).cost;
  const Volume<float> other = cheapestWays(cost, starts.high, progress).cost;
  Volume<std::uint8_t> nearerToOne(cost.geometry);
  std::vector<std::size_t> reached;
  for (std::size_t v = 0; v < one.voxels.size(); ++v) {
    if (std::isinf(one.voxels[v])) continue;
    nearerToOne.voxels[v] = one.voxels[v] < other.voxels[v] ? 1 : 0;
    reached.push_back(v);
  }
  spread(nearerToOne, reached);
  Shape gap{box, distanceOfMask(nearerToOne, progress).phi};
  // Only around the middle, and not where another vessel lies that is neither.
  const Vector3d middle = 0.5 * (places[0] + places[1]);
  const double half = kHalfGapVoxels * g.voxelMm();
  for (std::size_t v = 0; v < gap.phi.voxels.size(); ++v) {
    const std::int32_t part = parts.labels.voxels[v];
    const double away = (voxelCentre(cost.geometry, v) - middle).norm() - (reach - g.voxelMm());
    double d = std::max(std::fabs(static_cast<double>(gap.phi.voxels[v])) - half, away);
    if (part != 0 && part != joined) d = std::max(d, half);
    gap.phi.voxels[v] = static_cast<float>(d);
  }
  return gap;
}

}  // namespace angiomesh

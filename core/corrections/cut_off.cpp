// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/cut_off.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"
#include "core/field/wall_field.h"
#include "core/image/growing_box.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// A place may lie so far beside the vessel.
constexpr double kReachVoxels = 2.0;

/// Around it, for the vessel's axis.
constexpr double kAroundVoxels = 14.0;

[[noreturn]] void refusePlace(const Vector3d& placeLps) {
  throw InputError("there is no vessel at " + placeText(placeLps), "cut-off",
                   "give a place in a vessel, in mm LPS");
}

enum : std::uint8_t { kUnseen, kSection, kBeyond, kBefore };

class Cutter {
 public:
  Cutter(Volume<float>& phi, const Vector3d& placeLps, const Vector3d& normalLps)
      : phi_(phi), place_(placeLps), normal_(normalLps.normalized()), seen_(phi.geometry) {
    // As far as a step over a corner goes along the normal: the section is left by none.
    const Vector3d inGrid = phi.geometry.direction.transpose() * normal_;
    half_ = 0.5 * inGrid.cwiseAbs().dot(phi.geometry.spacing);
    clamp_ = 5.0 * phi.geometry.voxelMm();
  }

  /// The voxel of the vessel in the plane's layer that is nearest to the place.
  [[nodiscard]] std::optional<std::size_t> startNear(double reachVoxels) const {
    const Geometry& g = phi_.geometry;
    double nearest = reachVoxels * g.voxelMm() + 0.5 * g.spacing.norm();
    const auto box = boxOf(g, {place_}, nearest);
    if (!box) return std::nullopt;
    std::optional<std::size_t> start;
    for (int k = box->low[2]; k <= box->high[2]; ++k)
      for (int j = box->low[1]; j <= box->high[1]; ++j)
        for (int i = box->low[0]; i <= box->high[0]; ++i) {
          const std::size_t v = g.offset(i, j, k);
          const double away = (voxelCentre(g, v) - place_).norm();
          if (!(phi_.voxels[v] < 0.0F) || std::fabs(height(v)) > half_ || away >= nearest) continue;
          nearest = away;
          start = v;
        }
    return start;
  }

  /// What lies beyond the plane, from a voxel of the section on. @returns how many voxels
  std::size_t find(std::size_t start) {
    section_ = grow({start}, kSection, [&](double s) { return s >= -half_ && s <= half_; });
    beyond_ = grow(edge([&](double s) { return s > half_; }), kBeyond, [](double) { return true; });
    for (const std::size_t v : edge([&](double s) { return s < -half_; }))
      if (seen_.voxels[v] == kBeyond)
        throw InputError("both sides of the plane are connected by another way", "cut-off",
                         "cut where the vessel is part of no loop, or open the loop first");
    return beyond_.size();
  }

  VoxelBox cut() {
    const std::vector<std::size_t> before =
        grow(edge([&](double s) { return s < -half_; }), kBefore,
             [&](double s) { return s <= 0.0 && s > -clamp_; });
    for (const std::size_t v : beyond_) raise(v, std::max(height(v), half_));
    for (const std::size_t v : section_) raise(v, height(v));
    for (const std::size_t v : before) raise(v, height(v));
    return *changed_.box();
  }

  VoxelBox run(std::size_t start) {
    find(start);
    return cut();
  }

 private:
  [[nodiscard]] double height(std::size_t v) const {
    return (voxelCentre(phi_.geometry, v) - place_).dot(normal_);
  }

  /// The inside voxels beside the section at these heights over the plane.
  template <class Take>
  [[nodiscard]] std::vector<std::size_t> edge(Take take) const {
    std::vector<std::size_t> found;
    for (const std::size_t v : section_)
      forNeighbours(phi_.geometry, v, [&](std::size_t, std::size_t next) {
        if (phi_.voxels[next] < 0.0F && seen_.voxels[next] != kSection && take(height(next)))
          found.push_back(next);
      });
    return found;
  }

  template <class Take>
  std::vector<std::size_t> grow(const std::vector<std::size_t>& starts, std::uint8_t mark,
                                Take take) {
    std::vector<std::size_t> set;
    const auto visit = [&](std::size_t v) {
      if (seen_.voxels[v] != kUnseen || !(phi_.voxels[v] < 0.0F) || !take(height(v))) return;
      seen_.voxels[v] = mark;
      set.push_back(v);
    };
    for (const std::size_t v : starts) visit(v);
    for (std::size_t n = 0; n < set.size(); ++n)
      forNeighbours(phi_.geometry, set[n], [&](std::size_t, std::size_t next) { visit(next); });
    return set;
  }

  void raise(std::size_t v, double to) {
    float& value = phi_.voxels[v];
    value = std::max(value, static_cast<float>(std::min(to, clamp_)));
    changed_.add(phi_.geometry.indexOf(v));
  }

  Volume<float>& phi_;
  Vector3d place_, normal_;
  double half_ = 0.0, clamp_ = 0.0;
  Volume<std::uint8_t> seen_;
  std::vector<std::size_t> section_, beyond_;
  GrowingBox changed_;
};

}  // namespace

VoxelBox cutOff(Volume<float>& phi, const Vector3d& placeLps, const Vector3d& normalLps) {
  Cutter cutter(phi, placeLps, normalLps);
  const auto start = cutter.startNear(kReachVoxels);
  if (!start) refusePlace(placeLps);
  return cutter.run(*start);
}

VoxelBox cutOffSmallerSide(Volume<float>& phi, const Vector3d& placeLps) {
  const auto box = boxOf(phi.geometry, {placeLps}, kAroundVoxels * phi.geometry.voxelMm());
  if (!box) refusePlace(placeLps);
  const SplineField field = wallField(cropped(phi, *box), SplineKind::InterpolatingBspline);
  const auto vessel = vesselAt(field, placeLps, kReachVoxels);
  if (!vessel) refusePlace(placeLps);
  Cutter forward(phi, vessel->centreLps, vessel->axisLps);
  const auto start = forward.startNear(kReachVoxels);
  if (!start) refusePlace(placeLps);
  Cutter backward(phi, vessel->centreLps, -vessel->axisLps);
  return forward.find(*start) <= backward.find(*start) ? forward.cut() : backward.cut();
}

}  // namespace angiomesh

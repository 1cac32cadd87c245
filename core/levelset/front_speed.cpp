// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/front_speed.h"

#include <algorithm>
#include <cmath>

namespace angiomesh {

/// Values at a voxel and its six neighbours; a neighbour beyond the border is the voxel itself.
struct FrontSpeed::Neighbourhood {
  std::size_t voxel;
  Index3 at;
  std::array<std::ptrdiff_t, 3> before, after;  ///< offsets, 0 at the border
  double centre;
  std::array<double, 3> low, high;
};

FrontSpeed::FrontSpeed(const Volume<float>& vesselness, const Thresholds& thresholds, double gamma,
                       double d, bool acrossCrests)
    : vesselness_(vesselness),
      thresholds_(thresholds),
      gamma_(gamma),
      d_(std::fabs(d)),
      acrossCrests_(acrossCrests) {
  const Geometry& g = vesselness.geometry;
  for (std::size_t a = 0; a < 3; ++a)
    inverseStep_[a] = g.voxelMm() / g.spacing[static_cast<Eigen::Index>(a)];
}

FrontSpeed::Neighbourhood FrontSpeed::gather(const Volume<float>& phi, std::size_t voxel) const {
  const Geometry& g = phi.geometry;
  Neighbourhood n;
  n.voxel = voxel;
  n.at = g.indexOf(voxel);
  const float* here = phi.voxels.data() + voxel;
  n.centre = *here;
  std::ptrdiff_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    n.before[a] = n.at[a] > 0 ? -stride : 0;
    n.after[a] = n.at[a] + 1 < g.size[a] ? stride : 0;
    n.low[a] = here[n.before[a]];
    n.high[a] = here[n.after[a]];
    stride *= g.size[a];
  }
  return n;
}

double FrontSpeed::curvature(const Volume<float>& phi, std::size_t voxel) const {
  return curvature(phi, gather(phi, voxel));
}

double FrontSpeed::curvature(const Volume<float>& phi, const Neighbourhood& n) const {
  const float* here = phi.voxels.data() + n.voxel;
  std::array<double, 3> first;
  std::array<double, 3> second;
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = 0.5 * (n.high[a] - n.low[a]) * inverseStep_[a];
    second[a] = (n.high[a] - 2.0 * n.centre + n.low[a]) * inverseStep_[a] * inverseStep_[a];
  }
  const auto mixed = [&](std::size_t a, std::size_t b) {
    const double sum = static_cast<double>(here[n.after[a] + n.after[b]]) -
                       static_cast<double>(here[n.after[a] + n.before[b]]) -
                       static_cast<double>(here[n.before[a] + n.after[b]]) +
                       static_cast<double>(here[n.before[a] + n.before[b]]);
    return 0.25 * sum * inverseStep_[a] * inverseStep_[b];
  };
  const double xx = first[0] * first[0];
  const double yy = first[1] * first[1];
  const double zz = first[2] * first[2];
  const double square = xx + yy + zz;
  if (square < 1e-8) return 0.0;
  const double numerator =
      (second[1] + second[2]) * xx + (second[0] + second[2]) * yy + (second[0] + second[1]) * zz -
      2.0 * (first[0] * first[1] * mixed(0, 1) + first[0] * first[2] * mixed(0, 2) +
             first[1] * first[2] * mixed(1, 2));
  return numerator / (square * std::sqrt(square));
}

double FrontSpeed::vesselnessAtFront(const Neighbourhood& n) const {
  // Towards the surface along each axis: the side where phi changes sign, else the steeper one, so
  // that a vessel one voxel thin, where central differences vanish, still has a crossing.
  std::array<double, 3> slope;
  double square = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double forward = n.high[a] - n.centre;
    const double backward = n.centre - n.low[a];
    const bool crossesAfter = (n.high[a] < 0.0) != (n.centre < 0.0);
    const bool crossesBefore = (n.low[a] < 0.0) != (n.centre < 0.0);
    const bool useForward =
        crossesAfter != crossesBefore ? crossesAfter : std::fabs(forward) >= std::fabs(backward);
    slope[a] = (useForward ? forward : backward) * inverseStep_[a];
    square += slope[a] * slope[a];
  }
  Eigen::Vector3d index(n.at[0], n.at[1], n.at[2]);
  if (square > 1e-8)
    for (std::size_t a = 0; a < 3; ++a)
      index[static_cast<Eigen::Index>(a)] -=
          std::clamp(n.centre * slope[a] / square * inverseStep_[a], -1.0, 1.0);
  return interpolateLinear(vesselness_, index);
}

float FrontSpeed::change(const Volume<float>& phi, std::size_t voxel) const {
  const Neighbourhood n = gather(phi, voxel);
  double expanding =
      0.0;  // squares of the upwind |grad phi| of an expanding and of a shrinking front
  double shrinking = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double backward = (n.centre - n.low[a]) * inverseStep_[a];
    const double forward = (n.high[a] - n.centre) * inverseStep_[a];
    const double up = std::max(backward, 0.0);
    const double down = std::min(forward, 0.0);
    expanding += up * up + down * down;
    const double otherUp = std::min(backward, 0.0);
    const double otherDown = std::max(forward, 0.0);
    shrinking += otherUp * otherUp + otherDown * otherDown;
  }
  // On a crest of phi, as in a vessel or a gap one voxel wide, the upwind differences vanish and
  // the front stands still whatever its speed, unless |grad phi| is taken across the front there,
  // at most its nominal 1.
  const double most = acrossCrests_ ? 1.0 : 0.0;
  const double grow = std::sqrt(std::max(expanding, std::min(shrinking, most)));
  const double shrink = std::sqrt(std::max(shrinking, std::min(expanding, most)));
  const double p = vesselSpeed(vesselnessAtFront(n), thresholds_);
  const double kappa = std::clamp(curvature(phi, n), -2.0, 2.0);
  const double vessel = gamma_ * p * (p > 0.0 ? grow : shrink);
  const double bend = (1.0 - gamma_) * d_ * std::fabs(kappa) * grow;
  return static_cast<float>(-(vessel + bend));
}

}  // namespace angiomesh

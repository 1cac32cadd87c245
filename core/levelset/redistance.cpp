// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/redistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/surface/spline_field.h"

namespace angiomesh {
namespace {

constexpr std::size_t kGrain = 1024;

/// The voxels near the zero set and, for each, the closest point found so far (continuous index).
class ClosestPoints {
 public:
  ClosestPoints(const Volume<float>& phi, double bandVoxels)
      : phi_(phi),
        geometry_(phi.geometry),
        field_(phi, SplineKind::InterpolatingBspline),
        reach_(bandVoxels + 0.9),
        slot_(phi.geometry, -1) {
    for (int a = 0; a < 3; ++a) step_[a] = geometry_.spacing[a] / geometry_.voxelMm();
  }

  void findCrossings();
  void refine(std::size_t begin, const Progress& progress);
  bool grow();
  void relax();

  [[nodiscard]] std::size_t count() const { return voxels_.size(); }
  [[nodiscard]] std::uint32_t voxel(std::size_t n) const { return voxels_[n]; }
  [[nodiscard]] double distance(std::size_t n) const { return distance(voxels_[n], points_[n]); }

 private:
  [[nodiscard]] Eigen::Vector3d position(std::size_t voxel) const {
    const Index3 p = geometry_.indexOf(voxel);
    return {1.0 * p[0], 1.0 * p[1], 1.0 * p[2]};
  }
  [[nodiscard]] double distance(std::size_t voxel, const Eigen::Vector3d& point) const {
    return step_.cwiseProduct(position(voxel) - point).norm();
  }
  template <class F>
  void forBox(std::size_t voxel, F visit) const;
  [[nodiscard]] Eigen::Vector3d bestOfNeighbours(std::size_t voxel, Eigen::Vector3d best) const;
  [[nodiscard]] bool toZero(Eigen::Vector3d& point) const;
  [[nodiscard]] Eigen::Vector3d closest(std::size_t voxel, const Eigen::Vector3d& start) const;

  const Volume<float>& phi_;
  const Geometry& geometry_;
  SplineField field_;
  double reach_;
  Eigen::Vector3d step_;  ///< working voxels per voxel along each axis
  Volume<std::int32_t> slot_;
  std::vector<std::uint32_t> voxels_;
  std::vector<Eigen::Vector3d> points_;
  std::size_t frontier_ = 0;  ///< voxels_ before it have had their neighbours added
};

template <class F>
void ClosestPoints::forBox(std::size_t voxel, F visit) const {
  const Index3 p = geometry_.indexOf(voxel);
  for (int k = std::max(p[2] - 1, 0); k <= std::min(p[2] + 1, geometry_.size[2] - 1); ++k)
    for (int j = std::max(p[1] - 1, 0); j <= std::min(p[1] + 1, geometry_.size[1] - 1); ++j)
      for (int i = std::max(p[0] - 1, 0); i <= std::min(p[0] + 1, geometry_.size[0] - 1); ++i)
        visit(geometry_.offset(i, j, k));
}

/// Voxels with a neighbour of the other sign start from the nearest linear crossing on their grid
/// edges.
void ClosestPoints::findCrossings() {
  for (std::size_t voxel = 0; voxel < phi_.voxels.size(); ++voxel) {
    const double value = phi_.voxels[voxel];
    const Index3 p = geometry_.indexOf(voxel);
    double best = std::numeric_limits<double>::max();
    Eigen::Vector3d crossing;
    for (int a = 0; a < 3; ++a)
      for (int side = -1; side <= 1; side += 2) {
        Index3 q = p;
        q[a] += side;
        if (q[a] < 0 || q[a] >= geometry_.size[a]) continue;
        const double other = phi_.at(q[0], q[1], q[2]);
        if ((value < 0.0) == (other < 0.0)) continue;
        const double t = value / (value - other);
        if (t * step_[a] >= best) continue;
        best = t * step_[a];
        crossing = position(voxel);
        crossing[a] += side * t;
      }
    if (best == std::numeric_limits<double>::max()) continue;
    slot_.voxels[voxel] = static_cast<std::int32_t>(voxels_.size());
    voxels_.push_back(static_cast<std::uint32_t>(voxel));
    points_.push_back(crossing);
  }
}

Eigen::Vector3d ClosestPoints::bestOfNeighbours(std::size_t voxel, Eigen::Vector3d best) const {
  double least = best.allFinite() ? distance(voxel, best) : std::numeric_limits<double>::max();
  forBox(voxel, [&](std::size_t next) {
    const std::int32_t slot = slot_.voxels[next];
    if (slot < 0 || static_cast<std::size_t>(slot) >= points_.size()) return;
    const Eigen::Vector3d& candidate = points_[static_cast<std::size_t>(slot)];
    if (!candidate.allFinite()) return;
    const double d = distance(voxel, candidate);
    if (d < least) {
      least = d;
      best = candidate;
    }
  });
  return best;
}

/// Adds the neighbours of the newest voxels, as far as they are within reach. False when none was
/// added.
bool ClosestPoints::grow() {
  std::vector<std::uint32_t> fresh;
  for (std::size_t n = frontier_; n < voxels_.size(); ++n)
    forBox(voxels_[n], [&](std::size_t next) {
      if (slot_.voxels[next] >= 0) return;
      slot_.voxels[next] = std::numeric_limits<std::int32_t>::max();
      fresh.push_back(static_cast<std::uint32_t>(next));
    });
  frontier_ = voxels_.size();
  std::vector<Eigen::Vector3d> found(fresh.size());
  parallelFor(0, fresh.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n)
      found[n] = bestOfNeighbours(
          fresh[n], Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  });
  for (std::size_t n = 0; n < fresh.size(); ++n) {
    if (distance(fresh[n], found[n]) > reach_) {
      slot_.voxels[fresh[n]] = -1;
      continue;
    }
    slot_.voxels[fresh[n]] = static_cast<std::int32_t>(voxels_.size());
    voxels_.push_back(fresh[n]);
    points_.push_back(found[n]);
  }
  return voxels_.size() > frontier_;
}

/// Every voxel takes the best closest point among its neighbours.
void ClosestPoints::relax() {
  std::vector<Eigen::Vector3d> better(points_.size());
  parallelFor(0, points_.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) better[n] = bestOfNeighbours(voxels_[n], points_[n]);
  });
  points_ = std::move(better);
}

/// Newton steps along the gradient in working-voxel space. False when they leave or stall.
bool ClosestPoints::toZero(Eigen::Vector3d& point) const {
  for (int n = 0; n < 20; ++n) {
    const SplineField::Jet jet = field_.atIndex(point);
    const Eigen::Vector3d slope = jet.gradient.cwiseQuotient(step_);
    const double square = slope.squaredNorm();
    if (square < 1e-12) return false;
    Eigen::Vector3d move = -jet.value / square * slope;
    const double length = move.norm();
    if (length > 0.5) move *= 0.5 / length;
    point += move.cwiseQuotient(step_);
    if (length < 1e-5) return true;
  }
  return false;
}

/// Closest point of the zero set to a voxel from a starting point near it: steps within the tangent
/// plane, halved when they do not shorten the way, each followed by a projection.
Eigen::Vector3d ClosestPoints::closest(std::size_t voxel, const Eigen::Vector3d& start) const {
  const Eigen::Vector3d x = position(voxel);
  Eigen::Vector3d point = start;
  if (!toZero(point) || distance(voxel, point) > distance(voxel, start) + 0.5) return start;
  double least = distance(voxel, point);
  double part = 1.0;
  for (int n = 0; n < 12; ++n) {
    const Eigen::Vector3d normal = field_.atIndex(point).gradient.cwiseQuotient(step_).normalized();
    const Eigen::Vector3d away = step_.cwiseProduct(x - point);
    Eigen::Vector3d along = away - away.dot(normal) * normal;
    const double length = along.norm();
    if (length * part < 2e-3) break;
    along *= part * std::min(1.0, 1.0 / length);
    Eigen::Vector3d next = point + along.cwiseQuotient(step_);
    const bool found = toZero(next);
    const double d = distance(voxel, next);
    if (found && d < least) {
      point = next;
      least = d;
    } else {
      part *= 0.4;
    }
  }
  return point;
}

void ClosestPoints::refine(std::size_t begin, const Progress& progress) {
  parallelFor(begin, points_.size(), kGrain, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t n = first; n < last; ++n) points_[n] = closest(voxels_[n], points_[n]);
  });
}

}  // namespace

Volume<float> redistance(const Volume<float>& phi, double bandVoxels, const Progress& progress) {
  ClosestPoints closest(phi, bandVoxels);
  closest.findCrossings();
  if (closest.count() == 0)
    throw NumericError("the level set has no surface", "redistancing",
                       "nothing, or everything, lies inside: check the seeds and levelset.b");
  closest.refine(0, progress);
  for (bool grown = true; grown;) {
    progress.check();
    grown = closest.grow();
  }
  progress.report(0.4);
  for (int n = 0; n < 2; ++n) closest.relax();
  closest.refine(0, progress);
  progress.report(0.9);

  const double voxel = phi.geometry.voxelMm();
  const auto far = static_cast<float>(bandVoxels * voxel);
  Volume<float> out(phi.geometry);
  for (std::size_t i = 0; i < out.voxels.size(); ++i)
    out.voxels[i] = phi.voxels[i] < 0.0F ? -far : far;
  for (std::size_t n = 0; n < closest.count(); ++n) {
    const std::size_t at = closest.voxel(n);
    const auto d = static_cast<float>(closest.distance(n) * voxel);
    // A voxel inside keeps its sign even where the surface runs through it.
    if (d < far)
      out.voxels[at] = phi.voxels[at] < 0.0F ? -std::max(d, std::numeric_limits<float>::min()) : d;
  }
  progress.report(1.0);
  return out;
}

}  // namespace angiomesh

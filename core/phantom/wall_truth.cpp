// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/wall_truth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/phantom/rasterise.h"
#include "core/phantom/shape.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kGradientStep = 1e-4;  // voxels
constexpr double kCurvatureStep = 0.02;
constexpr double kTolerance = 1e-9;
constexpr int kFootSteps = 60;
constexpr int kMargin = 8;  // voxels around the volume where the index of the shape is fast

/// Ends of centre lines nearer than this are one place, voxels. No part of a voxel is a multiple
/// of it, so that no two of them fall on either side of a rounding.
constexpr double kSamePlace = 1.3717e-3;

using PlaceKey = std::array<long long, 3>;

PlaceKey keyOf(const Vector3d& point, double unit) {
  PlaceKey key{};
  for (int a = 0; a < 3; ++a)
    key[static_cast<std::size_t>(a)] = std::llround(point[a] / (kSamePlace * unit));
  return key;
}

std::vector<Branching> branchingsOf(const std::vector<CentreLineSegment>& lines, double unit) {
  struct Place {
    Branching branching;
    int ends = 0;
  };
  std::map<PlaceKey, Place> places;
  const auto meet = [&](const Vector3d& point, double radius, int ends) {
    Place& place = places[keyOf(point, unit)];
    place.branching.point = point;
    place.branching.radiusMm = std::max(place.branching.radiusMm, radius);
    place.ends += ends;
  };
  for (const CentreLineSegment& s : lines) {
    meet(s.from, s.radiusFromMm, 1);
    meet(s.to, s.radiusToMm, 1);
    if (s.parent < 0) continue;
    const CentreLineSegment& parent = lines[static_cast<std::size_t>(s.parent)];
    if (keyOf(s.from, unit) == keyOf(parent.to, unit)) continue;
    // It begins on the parent's way: that one passes.
    meet(s.from, nearestVesselRadius({parent}, s.from), 2);
  }
  std::vector<Branching> branchings;
  for (const auto& [key, place] : places)
    if (place.ends >= 3) branchings.push_back(place.branching);
  return branchings;
}

}  // namespace

double nearestVesselRadius(const std::vector<CentreLineSegment>& lines, const Vector3d& point) {
  double nearest = std::numeric_limits<double>::max();
  double found = 0.0;
  for (const CentreLineSegment& s : lines) {
    const Vector3d step = s.to - s.from;
    const double square = step.squaredNorm();
    const double t = square > 0.0 ? std::clamp((point - s.from).dot(step) / square, 0.0, 1.0) : 0.0;
    const double radius = s.radiusFromMm + t * (s.radiusToMm - s.radiusFromMm);
    const double distance = (point - s.from - t * step).norm() - radius;
    if (distance >= nearest) continue;
    nearest = distance;
    found = radius;
  }
  return found;
}

WallTruth::WallTruth(const PhantomParams& params) : grid_(phantomGeometry(params)) {
  const Shape shape = makeShape(params);
  Geometry wide = grid_;
  for (std::size_t a = 0; a < 3; ++a) wide.size[a] += 2 * kMargin;
  wide.origin -= kMargin * grid_.spacing;
  shape_ = std::make_shared<const ShapeIndex>(shape, wide);
  centreLines_ = shape.centreLines;
  branchings_ = branchingsOf(centreLines_, grid_.voxelMm());
  if (const auto* waist = std::get_if<WaistedTube>(&shape.solids.front()))
    throat_ = Throat{waist->centre, waist->axis, waist->throat, waist->halfLength};
}

Vector3d WallTruth::gradientAt(const Vector3d& point) const {
  const double step = kGradientStep * grid_.voxelMm();
  Vector3d gradient;
  for (int a = 0; a < 3; ++a) {
    const Vector3d move = step * Vector3d::Unit(a);
    gradient[a] = (shape_->signedDistance(point + move) - shape_->signedDistance(point - move)) /
                  (2.0 * step);
  }
  return gradient;
}

WallFoot WallTruth::footOf(const Vector3d& pointLps) const {
  const double unit = grid_.voxelMm();
  const double value = shape_->signedDistance(pointLps);
  WallFoot foot{pointLps, Vector3d::UnitX(), value};
  double level = value;
  Vector3d aside = Vector3d::Zero();
  for (int step = 0; step < kFootSteps; ++step) {
    const Vector3d gradient = gradientAt(foot.point);
    double steepness = gradient.norm();
    if (steepness > 1e-3)
      foot.normal = gradient / steepness;
    else
      steepness = 1.0;  // on an axis: any way out
    if (step > 0) {
      const Vector3d back = pointLps - foot.point;
      aside = back - back.dot(foot.normal) * foot.normal;
      // Where the steps along the wall go to and fro, shorter ones end.
      if (step > 12) aside *= 0.5;
      if (aside.norm() < kTolerance * unit && std::fabs(level) < kTolerance * unit) break;
      foot.point += aside;
      level = shape_->signedDistance(foot.point);
    }
    foot.point -= level / std::max(steepness, 0.25) * foot.normal;
    level = shape_->signedDistance(foot.point);
  }
  const double distance = (pointLps - foot.point).norm();
  foot.signedDistanceMm = value < 0.0 ? -distance : distance;
  return foot;
}

WallCurvature WallTruth::curvatureAt(const WallFoot& foot) const {
  const double h = kCurvatureStep * grid_.voxelMm();
  const Vector3d u = h * foot.normal.unitOrthogonal();
  const Vector3d v = foot.normal.cross(u);
  const auto at = [&](double a, double b) {
    return shape_->signedDistance(foot.point + a * u + b * v);
  };
  const double scale = 1.0 / (h * h * std::max(gradientAt(foot.point).norm(), 1e-3));
  const double middle = 2.0 * at(0, 0);
  const double uu = scale * (at(1, 0) - middle + at(-1, 0));
  const double vv = scale * (at(0, 1) - middle + at(0, -1));
  const double uv = 0.25 * scale * (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1));
  const double mean = 0.5 * (uu + vv);
  const double half = std::sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
  return {mean + half, mean - half};
}

double WallTruth::radiusAt(const Vector3d& pointLps) const {
  return nearestVesselRadius(centreLines_, pointLps);
}

bool WallTruth::nearBranching(const Vector3d& pointLps, double share) const {
  return std::any_of(branchings_.begin(), branchings_.end(), [&](const Branching& b) {
    return (pointLps - b.point).norm() < (1.0 + share) * b.radiusMm;
  });
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/lumen_probe.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/exact_math.h"
#include "core/base/statistics.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr int kDirections = 128;
constexpr int kSectionRays = 48;  // even: each has one in the opposite direction

/// Points of a spiral from pole to pole that are evenly spread (Fibonacci's lattice).
std::vector<Vector3d> evenDirections(int count) {
  const double golden = 0.5 * (3.0 - std::sqrt(5.0));
  std::vector<Vector3d> directions;
  for (int n = 0; n < count; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * portableCosTurns(golden * n), r * portableSinTurns(golden * n), z);
  }
  return directions;
}

/// Lengths of the rays of a section as they count for its area. A round or oval section seen from
/// its centre looks the same in opposite directions.
std::vector<double> expectedLengths(const std::vector<LumenProbe::Ray>& rays) {
  std::vector<double> lengths;
  for (const LumenProbe::Ray& ray : rays) lengths.push_back(ray.lengthMm);
  std::vector<double> expected = lengths;
  const double middle = upperMedian(expected);
  const std::size_t half = rays.size() / 2;
  for (std::size_t n = 0; n < rays.size(); ++n) {
    const std::size_t opposite = (n + half) % rays.size();
    const double other = lengths[opposite];
    const double most = std::min(3.0 * middle, std::max(1.5 * middle, 1.3 * other));
    expected[n] = std::min(lengths[n], most);
    // The volume ends before the vessel does.
    if (rays[n].end == LumenProbe::End::Border && rays[opposite].end == LumenProbe::End::Wall)
      expected[n] = std::max(expected[n], std::min(other, most));
  }
  return expected;
}

}  // namespace

Plane::Plane(const Vector3d& axis) {
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  u = axis.cross(Vector3d::Unit(least)).normalized();
  v = axis.cross(u);
}

LumenProbe::LumenProbe(const SplineField& phi)
    : phi_(phi),
      voxelMm_(phi.geometry().voxelMm()),
      toIndex_(phi.geometry().physicalToIndexMatrix()),
      around_(evenDirections(kDirections)) {}

Vector3d LumenProbe::intoVolume(const Vector3d& point) const {
  const Geometry& g = phi_.geometry();
  Vector3d index = toIndex_ * (point - g.origin);
  for (int a = 0; a < 3; ++a)
    index[a] = std::clamp(index[a], 0.0, g.size[static_cast<std::size_t>(a)] - 1.0);
  return g.toPhysical(index);
}

double LumenProbe::toBorder(const Vector3d& from, const Vector3d& direction) const {
  const Geometry& g = phi_.geometry();
  const Vector3d index = toIndex_ * (from - g.origin);
  const Vector3d slope = toIndex_ * direction;
  double most = std::numeric_limits<double>::max();
  for (int a = 0; a < 3; ++a) {
    if (std::fabs(slope[a]) < 1e-12) continue;
    const double face = slope[a] > 0.0 ? g.size[static_cast<std::size_t>(a)] - 1.0 : 0.0;
    most = std::min(most, (face - index[a]) / slope[a]);
  }
  return std::max(most, 0.0);
}

LumenProbe::Ray LumenProbe::cast(const Vector3d& from, const Vector3d& direction) const {
  const double most = toBorder(from, direction);
  double in = 0.0;  // inside so far
  double value = phi_.valueAt(from);
  if (value >= 0.0) return {direction, 0.0, End::Wall};
  // phi bounds the way that is free, but for what the interpolation does to it.
  for (;;) {
    if (in >= most) return {direction, most, End::Border};
    const double next = std::min(in + std::max(-0.8 * value, 0.1 * voxelMm_), most);
    const double there = phi_.valueAt(from + next * direction);
    if (there < 0.0) {
      in = next;
      value = there;
      continue;
    }
    double out = next;
    while (out - in > 1e-3 * voxelMm_) {
      const double middle = 0.5 * (in + out);
      (phi_.valueAt(from + middle * direction) < 0.0 ? in : out) = middle;
    }
    return {direction, 0.5 * (in + out), End::Wall};
  }
}

std::vector<LumenProbe::Ray> LumenProbe::castAround(const Vector3d& from) const {
  std::vector<Ray> rays;
  rays.reserve(around_.size());
  for (const Vector3d& direction : around_) rays.push_back(cast(from, direction));
  return rays;
}

Vector3d LumenProbe::normalAt(const Vector3d& point) const {
  const Vector3d gradient = phi_.at(point).gradient;
  const double slope = gradient.norm();
  return slope > 1e-6 ? Vector3d(gradient / slope) : Vector3d::Zero();
}

std::optional<LumenSection> LumenProbe::section(const Vector3d& point, const Vector3d& axis) const {
  if (!(axis.squaredNorm() > 0.5) || !isInside(point) ||
      (intoVolume(point) - point).norm() > 1e-6 * voxelMm_)
    return std::nullopt;
  const Plane plane(axis);
  LumenSection section;
  section.centreLps = point;
  for (int pass = 0; pass < 8; ++pass) {
    std::vector<Ray> rays;
    for (int n = 0; n < kSectionRays; ++n) {
      const double turns = static_cast<double>(n) / kSectionRays;
      rays.push_back(cast(section.centreLps,
                          portableCosTurns(turns) * plane.u + portableSinTurns(turns) * plane.v));
    }
    const std::vector<double> lengths = expectedLengths(rays);
    double area = 0.0;
    Vector3d moment = Vector3d::Zero();
    for (std::size_t n = 0; n < rays.size(); ++n) {
      const double square = lengths[n] * lengths[n];
      area += std::numbers::pi / kSectionRays * square;
      moment +=
          2.0 * std::numbers::pi / (3.0 * kSectionRays) * square * lengths[n] * rays[n].direction;
    }
    section.radiusMm = std::sqrt(area / std::numbers::pi);
    section.cutShare =
        static_cast<double>(std::count_if(rays.begin(), rays.end(),
                                          [](const Ray& ray) { return ray.end == End::Border; })) /
        kSectionRays;
    section.inscribedMm = *std::min_element(lengths.begin(), lengths.end());
    if (area <= 0.0) return std::nullopt;
    const Vector3d step = moment / area;
    const Vector3d centre = intoVolume(section.centreLps + step);
    if (step.norm() < 0.01 * voxelMm_ || !isInside(centre)) break;
    section.centreLps = centre;
  }
  return section;
}

}  // namespace angiomesh

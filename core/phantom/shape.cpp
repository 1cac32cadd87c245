// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/exact_math.h"

namespace angiomesh {
namespace {

double smoothMinimum(double a, double b, double k) {
  const double h = std::max(k - std::fabs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * h * k / 6.0;
}

}  // namespace

RoundCone::RoundCone(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom,
                     double radiusTo)
    : from_(from),
      direction_(to - from),
      length_(0.0),
      radiusFrom_(radiusFrom),
      radiusTo_(radiusTo),
      sine_(0.0),
      cosine_(1.0) {
  length_ = std::sqrt(direction_.dot(direction_));
  if (length_ <= std::fabs(radiusFrom - radiusTo)) {  // one ball holds the other
    if (radiusTo > radiusFrom) {
      from_ = to;
      radiusFrom_ = radiusTo;
    }
    length_ = 0.0;
    direction_ = Eigen::Vector3d::UnitX();
    radiusTo_ = radiusFrom_;
    return;
  }
  direction_ /= length_;
  sine_ = (radiusFrom - radiusTo) / length_;
  cosine_ = std::sqrt(1.0 - sine_ * sine_);
}

double RoundCone::signedDistance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - from_;
  const double square = p.dot(p);
  const double x = p.dot(direction_);
  const double y = std::sqrt(std::max(square - x * x, 0.0));
  const double along = x * cosine_ - y * sine_;  // along the wall, from the first ball's edge
  if (along <= 0.0) return std::sqrt(square) - radiusFrom_;
  if (along >= length_ * cosine_) {
    const double beyond = x - length_;
    return std::sqrt(beyond * beyond + y * y) - radiusTo_;
  }
  return x * sine_ + y * cosine_ - radiusFrom_;
}

double ArcTube::signedDistance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - centre;
  const double a = p.dot(toMiddle);
  const double b = std::fabs(p.dot(side));
  const double inPlane = std::sqrt(a * a + b * b);
  const double offPlane = std::max(p.dot(p) - inPlane * inPlane, 0.0);
  if (a >= inPlane * cosHalf) {
    const double d = inPlane - majorRadius;
    return std::sqrt(d * d + offPlane) - radius;
  }
  const double da = a - majorRadius * cosHalf;
  const double db = b - majorRadius * sinHalf;
  return std::sqrt(da * da + db * db + offPlane) - radius;
}

Eigen::Vector3d HelixTube::centreLineAt(double turns) const {
  return centre +
         coilRadius * (portableCosTurns(turns) * first + portableSinTurns(turns) * second) +
         pitch * turns * axis;
}

double HelixTube::signedDistance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - centre;
  const double x = p.dot(first);
  const double y = p.dot(second);
  const double z = p.dot(axis);
  // The nearest point is within half a turn of the one at the same height, or within a turn of the
  // end next to it: a whole turn towards that height keeps the angle and comes nearer.
  constexpr int samples = 24;
  const double level = z / pitch;
  const double start = std::max(-halfTurns, std::min(level - 0.5, halfTurns - 1.0));
  double best = std::numeric_limits<double>::max();
  double turns = start;
  double c = portableCosTurns(start);
  double s = portableSinTurns(start);
  const double stepCos = portableCosTurns(1.0 / samples);
  const double stepSin = portableSinTurns(1.0 / samples);
  for (int i = 0; i <= samples; ++i) {
    const double t = start + static_cast<double>(i) / samples;
    if (t > halfTurns * (1.0 + 1e-12)) break;
    const double dz = z - pitch * t;
    const double value = dz * dz - 2.0 * coilRadius * (x * c + y * s);
    if (value < best) {
      best = value;
      turns = t;
    }
    const double next = c * stepCos - s * stepSin;
    s = s * stepCos + c * stepSin;
    c = next;
  }
  const double rise = pitch / (2.0 * std::numbers::pi);  // per radian
  for (int i = 0; i < 6; ++i) {
    c = portableCosTurns(turns);
    s = portableSinTurns(turns);
    const double slope = coilRadius * (x * s - y * c) - rise * (z - pitch * turns);
    const double bend = coilRadius * (x * c + y * s) + rise * rise;
    if (bend <= 0.0) break;
    const double limit = 1.0 / samples;
    turns -= std::clamp(slope / bend / (2.0 * std::numbers::pi), -limit, limit);
    turns = std::clamp(turns, -halfTurns, halfTurns);
  }
  const Eigen::Vector3d d = point - centreLineAt(turns);
  return std::sqrt(d.dot(d)) - radius;
}

double WaistedTube::radiusAt(double s) const {
  if (std::fabs(s) >= halfLength) return radius;
  return radius - (radius - throat) * 0.5 * (1.0 + portableCosTurns(0.5 * s / halfLength));
}

double WaistedTube::signedDistance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - centre;
  const double s = p.dot(axis);
  const double rho = std::sqrt(std::max(p.dot(p) - s * s, 0.0));
  const double slope = 0.5 * (radius - throat) * std::numbers::pi / halfLength;
  return (rho - radiusAt(s)) / std::sqrt(1.0 + slope * slope);
}

double signedDistance(const Solid& solid, const Eigen::Vector3d& point) {
  return std::visit([&](const auto& s) { return s.signedDistance(point); }, solid);
}

double Shape::signedDistance(const Eigen::Vector3d& point) const {
  double value = std::numeric_limits<double>::max();
  for (const Solid& solid : solids) {
    const double d = angiomesh::signedDistance(solid, point);
    value = blendMm > 0.0 ? smoothMinimum(value, d, blendMm) : std::min(value, d);
  }
  return value;
}

double Shape::signedDistance(const Eigen::Vector3d& point, const std::vector<int>& numbers) const {
  double value = std::numeric_limits<double>::max();
  for (const int n : numbers) {
    const double d = angiomesh::signedDistance(solids[static_cast<std::size_t>(n)], point);
    value = blendMm > 0.0 ? smoothMinimum(value, d, blendMm) : std::min(value, d);
  }
  return value;
}

std::array<Eigen::Vector3d, 2> acrossOf(const Eigen::Vector3d& axis) {
  int least = 0;
  for (int a = 1; a < 3; ++a)
    if (std::fabs(axis[a]) < std::fabs(axis[least])) least = a;
  Eigen::Vector3d u = Eigen::Vector3d::Unit(least) - axis[least] * axis;
  u /= u.norm();
  return {u, Eigen::Vector3d(axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2],
                             axis[0] * u[1] - axis[1] * u[0])};
}

}  // namespace angiomesh

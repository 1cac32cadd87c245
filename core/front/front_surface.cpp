// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/front_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh {
namespace {

// The circle that the wished corner runs on: centre + radius (cos t left + sin t up).
struct Circle {
  Eigen::Vector3d centre, left, up;
  double radius;

  Circle(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish) {
    const Eigen::Vector3d u = (b.point - a.point).normalized();
    Eigen::Vector3d n = a.normal + b.normal;
    n -= n.dot(u) * u;
    up = n.normalized();
    left = up.cross(u);
    centre = a.point + wish.along * u;
    radius = wish.height;
  }
};

constexpr double kLargestTurn = 1.0471975511965976;  // 60 degrees
// Where fronts meet edges are a little longer than asked for; with this the mean over tori, tubes
// and trees is the wanted length, and an inscribed mesh loses the volume that the length stands
// for.
constexpr double kFrontShare = 0.965;
constexpr double kLeastAgreement = 0.3;  // cosine of the normals, apex to base

}  // namespace

bool WallSurface::turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                       FrontPoint& apex) const {
  const Circle circle(a, b, wish);
  // The direction (cos t, sin t) is turned by small steps, so no trigonometry is needed.
  double c = 1.0, s = 0.0, turned = 0.0;
  double below = -kLargestTurn, above = kLargestTurn;
  for (int n = 0; n < 12; ++n) {
    apex.point = circle.centre + circle.radius * (c * circle.left + s * circle.up);
    const SplineField::Jet jet = field_.at(apex.point);
    const double slope = jet.gradient.norm();
    if (!(slope > 1e-12)) return false;
    if (std::fabs(jet.value) < 1e-7 * slope * circle.radius) {
      apex.normal = jet.gradient / slope;
      if (apex.normal.dot(circle.up) < kLeastAgreement) return false;
      // Beyond the outermost voxel centres the field is extrapolated: the wall ends there.
      if (!field_.geometry().holds(apex.point)) return false;
      apex.length = lengthAt(apex.point);
      return true;
    }
    // phi grows outwards: where it is positive the surface lies at a smaller turn.
    (jet.value > 0.0 ? above : below) = turned;
    const double rate = circle.radius * jet.gradient.dot(c * circle.up - s * circle.left);
    double step =
        rate > 0.2 * slope * circle.radius ? -jet.value / rate : (jet.value > 0.0 ? -0.2 : 0.2);
    step = std::clamp(step, -0.5, 0.5);
    if (turned + step <= below || turned + step >= above) step = 0.5 * (below + above) - turned;
    turned += step;
    if (std::fabs(turned) > 0.999 * kLargestTurn) return false;
    // The tangent half-angle form keeps the direction a unit vector to rounding.
    const double h = 0.5 * turned * (1.0 + turned * turned / 12.0 * (1.0 + turned * turned / 10.0));
    c = (1.0 - h * h) / (1.0 + h * h);
    s = 2.0 * h / (1.0 + h * h);
  }
  return false;
}

double WallSurface::lengthAt(const Eigen::Vector3d& point) const {
  return kFrontShare * size_.at(point);
}

bool WallSurface::settle(const Eigen::Vector3d& near, FrontPoint& point) const {
  point.point = near;
  if (!field_.projectToZero(point.point)) return false;
  const SplineField::Jet jet = field_.at(point.point);
  const double slope = jet.gradient.norm();
  if (!(slope > 1e-12)) return false;
  point.normal = jet.gradient / slope;
  point.length = lengthAt(point.point);
  return true;
}

bool CapSurface::turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                      FrontPoint& apex) const {
  const Circle circle(a, b, wish);
  apex.point = circle.centre + circle.radius * circle.left;
  apex.normal = a.normal;
  apex.length = size_.at(apex.point);
  return field_.geometry().holds(apex.point, 1e-6) && field_.at(apex.point).value < 0.0;
}

}  // namespace angiomesh

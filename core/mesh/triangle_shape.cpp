// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/triangle_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiomesh {
namespace {

// Arc tangent of t in [0, 1], in degrees: the argument is halved twice in angle, which leaves
// t < 0.2 for the Taylor series.
double arcTangentDegrees(double t) {
  t /= 1.0 + std::sqrt(1.0 + t * t);
  t /= 1.0 + std::sqrt(1.0 + t * t);
  const double square = t * t;
  double series = 0.0;
  for (int n = 21; n >= 1; n -= 2) series = 1.0 / n - square * series;
  return 4.0 * t * series * (180.0 / std::numbers::pi);
}

}  // namespace

double angleDegrees(double y, double x) {
  const double width = std::abs(x);
  if (y == 0.0 && width == 0.0) return 0.0;
  const double acute =
      y <= width ? arcTangentDegrees(y / width) : 90.0 - arcTangentDegrees(width / y);
  return x < 0.0 ? 180.0 - acute : acute;
}

TriangleShape triangleShape(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c;
  const double twiceArea = ab.cross(ca).norm();
  if (!(twiceArea > 0.0)) return {};
  const double angles[3] = {angleDegrees(twiceArea, -ab.dot(ca)),
                            angleDegrees(twiceArea, -bc.dot(ab)),
                            angleDegrees(twiceArea, -ca.dot(bc))};
  const double x = ab.norm(), y = bc.norm(), z = ca.norm();
  TriangleShape shape;
  shape.minAngle = std::min({angles[0], angles[1], angles[2]});
  shape.maxAngle = std::max({angles[0], angles[1], angles[2]});
  // r = area / s, R = xyz / (4 area), s half the perimeter.
  shape.radiusRatio = 4.0 * twiceArea * twiceArea / ((x + y + z) * x * y * z);
  shape.aspectRatio = std::max({x, y, z}) * (x + y + z) / (2.0 * std::numbers::sqrt3 * twiceArea);
  return shape;
}

double largestCosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c;
  const double x = ab.norm(), y = bc.norm(), z = ca.norm();
  if (!(x > 0.0 && y > 0.0 && z > 0.0)) return 1.0;
  return std::max({-ab.dot(ca) / (x * z), -bc.dot(ab) / (x * y), -ca.dot(bc) / (y * z)});
}

Eigen::Vector3d unitNormal(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c) {
  const Eigen::Vector3d n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0.0 ? Eigen::Vector3d(n / length) : Eigen::Vector3d::Zero();
}

}  // namespace angiomesh

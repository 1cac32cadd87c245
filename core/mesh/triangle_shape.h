// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace angiomesh {

/// Angles in degrees, 2 * inradius / circumradius, and longest edge / (inradius * 12^0.5) of one
/// triangle. One without area has the angles 0 and 180, the radius ratio 0 and an infinite aspect
/// ratio.
struct TriangleShape {
  double minAngle = 0.0, maxAngle = 180.0, radiusRatio = 0.0;
  double aspectRatio = std::numeric_limits<double>::infinity();

  /// Equiangular, as in Fluent: 0 is equilateral, 1 has no area.
  [[nodiscard]] double skewness() const {
    return std::max((maxAngle - 60.0) / 120.0, (60.0 - minAngle) / 60.0);
  }
};

TriangleShape triangleShape(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c);

/// The angle of the vector (x, y), y >= 0, in degrees, 0..180; the same bits on every processor.
double angleDegrees(double y, double x);

/// The largest cosine of a triangle's angles, 1 where an edge has no length.
double largestCosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The unit normal of a triangle, 0 where it has no area.
Eigen::Vector3d unitNormal(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace angiomesh {

/// Angles in degrees and 2 * inradius / circumradius of one triangle. A triangle without area has
/// the angles 0 and 180 and the ratio 0.
struct TriangleShape {
  double minAngle = 0.0, maxAngle = 180.0, radiusRatio = 0.0;
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

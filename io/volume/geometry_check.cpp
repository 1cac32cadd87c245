// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/geometry_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace angiomesh {
namespace {

constexpr double kOff = 1e-3;  // headers with three digits
// Microscopes and scouts of the whole body are beyond.
constexpr double kLeastVoxelMm = 0.01, kLargestVoxelMm = 10.0;
constexpr double kLeastSideMm = 1.0, kLargestSideMm = 2500.0;

std::string triple(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text.precision(4);
  text << v.x() << " x " << v.y() << " x " << v.z();
  return text.str();
}

/// Of the axis that is furthest from a right angle to another one.
double skewDegrees(const Eigen::Matrix3d& axes) {
  const Eigen::Matrix3d dots = (axes.transpose() * axes).cwiseAbs();
  const double most = std::max({dots(0, 1), dots(0, 2), dots(1, 2)});
  return std::asin(std::min(most, 1.0)) * 180.0 / std::numbers::pi;
}

}  // namespace

std::vector<std::string> checkGeometry(Geometry& g) {
  std::vector<std::string> warnings;
  const Eigen::Vector3d lengths = g.direction.colwise().norm();
  if (!lengths.allFinite() || !(lengths.minCoeff() > 0.0)) return warnings;
  if ((lengths.array() - 1.0).abs().maxCoeff() > kOff) {
    g.direction = g.direction * lengths.cwiseInverse().asDiagonal();
    g.spacing = g.spacing.cwiseProduct(lengths);
    warnings.push_back("the axes of the file's direction matrix are not of length 1 but " +
                       triple(lengths) + ": the voxels are taken as " + triple(g.spacing) + " mm");
  }
  const double skew = skewDegrees(g.direction * lengths.cwiseInverse().asDiagonal());
  if (std::sin(skew * std::numbers::pi / 180.0) > kOff) {
    std::ostringstream degrees;
    degrees.precision(3);
    degrees << skew;
    warnings.push_back("the axes of the grid are not at right angles, by " + degrees.str() +
                       " degrees");
  }
  const Eigen::Vector3d sides =
      g.spacing.cwiseProduct(Eigen::Vector3d(g.size[0], g.size[1], g.size[2]));
  if (g.spacing.minCoeff() < kLeastVoxelMm || g.spacing.maxCoeff() > kLargestVoxelMm)
    warnings.push_back("voxels of " + triple(g.spacing) +
                       " mm are none of a scan of vessels: is the spacing in millimetres?");
  else if (sides.maxCoeff() < kLeastSideMm || sides.maxCoeff() > kLargestSideMm)
    warnings.push_back("a volume of " + triple(sides) +
                       " mm is none of a scan of vessels: is the spacing in millimetres?");
  return warnings;
}

bool sameGrid(const Geometry& a, const Geometry& b) {
  constexpr double kTolerance = 1e-4;
  return a.size == b.size && a.spacing.isApprox(b.spacing, kTolerance) &&
         a.direction.isApprox(b.direction, 10.0 * kTolerance) &&
         (a.origin - b.origin).norm() < 0.1 * b.voxelMm();
}

}  // namespace angiomesh

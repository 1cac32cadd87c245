// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <variant>
#include <vector>

#include "core/phantom/curve_tube.h"
#include "core/phantom/phantom.h"

// Solids with a signed distance in closed form, negative inside. All lengths in mm. The results are
// made of the four basic operations, square roots and core/base/exact_math.h only, so that a
// phantom has the same bits on every machine.

namespace angiomesh {

/// The convex hull of two balls (a tapering capsule). Exact distance.
class RoundCone {
 public:
  RoundCone(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom,
            double radiusTo);
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;

 private:
  Eigen::Vector3d from_, direction_;
  double length_, radiusFrom_, radiusTo_;
  double sine_, cosine_;  // of the angle between axis and wall
};

/// A tube around the circular arc centre + majorRadius (cos t toMiddle + sin t side), |t| <= half
/// the opening; toMiddle and side are orthonormal. cosHalf = -1 is a whole torus. Exact distance.
struct ArcTube {
  Eigen::Vector3d centre, toMiddle, side;
  double majorRadius = 0.0, cosHalf = -1.0, sinHalf = 0.0, radius = 0.0;
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;
};

/// A tube with ball ends around the helix centre + coilRadius (cos t first + sin t second) + axis *
/// pitch t / 2 pi, |t| <= 2 pi halfTurns (at least half a turn); first, second, axis orthonormal.
/// Exact distance.
struct HelixTube {
  Eigen::Vector3d centre, first, second, axis;
  double coilRadius = 0.0, pitch = 0.0, halfTurns = 0.5, radius = 0.0;
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;
  [[nodiscard]] Eigen::Vector3d centreLineAt(double turns) const;
};

/// An endless straight tube narrowed around `centre`: its radius is radius - (radius - throat) (1 +
/// cos(pi s / halfLength)) / 2 at |s| < halfLength along the axis. The zero set is exact; the value
/// is the radial distance to the wall divided by the largest slope factor, so never more than the
/// distance.
struct WaistedTube {
  Eigen::Vector3d centre, axis;
  double radius = 0.0, throat = 0.0, halfLength = 0.0;
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;
  [[nodiscard]] double radiusAt(double s) const;
};

using Solid = std::variant<RoundCone, ArcTube, HelixTube, WaistedTube, CurveTube>;
double signedDistance(const Solid& solid, const Eigen::Vector3d& point);

/// The union of solids; with blendMm = k > 0 a smooth union: min(a, b) - k/6 max(1 - |a - b|/k,
/// 0)^3 (the cubic polynomial minimum: two continuous derivatives), folded in order.
struct Shape {
  std::vector<Solid> solids;
  double blendMm = 0.0;
  std::vector<CentreLineSegment> centreLines;  ///< inside the volume
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;
  /// Of the solids with these numbers only.
  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point,
                                      const std::vector<int>& numbers) const;
};

/// Two directions of length 1 across an axis of length 1, and across each other.
std::array<Eigen::Vector3d, 2> acrossOf(const Eigen::Vector3d& axis);

/// Origin 0, identity direction. @throws InputError for a size or spacing that makes no sense
Geometry phantomGeometry(const PhantomParams& params);

/// Of any kind. @throws as makePhantom()
Shape makeShape(const PhantomParams& params, const Progress& progress = {});

/// Every kind except the tree. @throws InputError when the shape does not fit into the volume
Shape analyticShape(const PhantomParams& params);

}  // namespace angiomesh

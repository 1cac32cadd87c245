// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace angiomesh {

/// The union of the balls around a natural cubic spline through given points, whose radius is a
/// natural cubic spline through given radii: a bent vessel of varying width with ball ends, smooth
/// while the centre line bends less than its radius. Exact distance outside; all in mm.
class CurveTube {
 public:
  /// @param points at least two, passed at the parameters 0, 1, 2, ...; the radius must change less
  /// than the place does
  CurveTube(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radii);

  [[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const;
  [[nodiscard]] Eigen::Vector3d centreAt(double t) const;
  [[nodiscard]] Eigen::Vector3d tangentAt(double t) const;  ///< of length 1
  [[nodiscard]] double radiusAt(double t) const;
  [[nodiscard]] double length() const { return static_cast<double>(pieces_.size()); }

 private:
  using Ball = Eigen::Vector4d;  // centre and radius
  struct Piece {
    Ball a, b, c, d;                        // a + b s + c s^2 + d s^3, 0 <= s <= 1
    Eigen::Vector3d middle{0.0, 0.0, 0.0};  // with `reach`: a ball that holds the piece's walls
    double reach = 0.0;
  };
  /// Numbers of the piece and the place in it.
  [[nodiscard]] std::size_t pieceAt(double t, double& s) const;
  [[nodiscard]] double refined(const Eigen::Vector3d& point, double t) const;

  std::vector<Piece> pieces_;
  std::vector<Ball> samples_;
};

}  // namespace angiomesh

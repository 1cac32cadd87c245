// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh::remeshing {

using Eigen::Vector3d;

/// How far a triangle is from equilateral: 0 there, 1 at the worst that is aimed at (an angle of 35
/// or 103 degrees, or 2 r / R = 0.65), more beyond; 10 and more where it has no shape.
inline double badness(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  double p = (c - b).squaredNorm(), q = (a - c).squaredNorm(), r = (b - a).squaredNorm();
  if (p > q) std::swap(p, q);
  if (q > r) std::swap(q, r);
  if (p > q) std::swap(p, q);
  const double pq = std::sqrt(p * q), qr = std::sqrt(q * r);
  if (!(p > 0.0)) return 20.0;
  constexpr double cosSmall = 0.819152, cosLarge = -0.224951, cosEven = 0.5;
  const double small = (q + r - p) / (2.0 * qr), large = (p + q - r) / (2.0 * pq);
  const double sine2 = 1.0 - large * large;  // 4 A^2 = p q sine2
  const double ratio =
      4.0 * p * q * sine2 / (std::sqrt(p * q * r) * (std::sqrt(p) + std::sqrt(q) + std::sqrt(r)));
  return std::max({(small - cosEven) / (cosSmall - cosEven),
                   (cosEven - large) / (cosEven - cosLarge), (1.0 - ratio) / 0.35});
}

}  // namespace angiomesh::remeshing

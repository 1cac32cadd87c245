// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace angiomesh {

/// The quadric q(y) = a + b.y + y.C y / 2 that comes nearest to what is known of a wall around a
/// place: minimises
///
///   sum w (q(y) - t)^2 + steadiness |grad q(y) - n|^2
///
/// over points y with unit normals n, t the distance that q ought to have there. The second part
/// fixes the scale of q (Kazhdan, Bolitho and Hoppe 2006 fit normals alone); planes, cylinders and
/// balls are met exactly. The sums are taken in single precision, eight at a time in a fixed order.
class LocalQuadric {
 public:
  static constexpr std::size_t kLanes = 8;
  static constexpr int kTerms = 10;

  /// Points are given relative to the place and divided by `unit`.
  explicit LocalQuadric(double unit) : unit_(unit) {}

  struct Point {
    Eigen::Vector3f at, normal;
    float weight = 0.0F, target = 0.0F;  ///< `target` in the length that `unit` is in
  };
  void add(const Point& point) {
    for (Eigen::Index a = 0; a < 3; ++a) {
      at_[static_cast<std::size_t>(a)][used_] = point.at[a];
      normal_[static_cast<std::size_t>(a)][used_] = point.normal[a];
    }
    weight_[used_] = point.weight;
    target_[used_] = point.target;
    if (++used_ == kLanes) sum();
  }

  struct Fit {
    bool found = false;
    double offset = 0.0;  ///< of the zero set from the place, along its normal
    double mean = 0.0;    ///< sum of the principal curvatures
    double gauss = 0.0;   ///< their product
    double weight = 0.0;  ///< of all points
  };
  /// Of all points so far. Not found where they say too little.
  /// @param steadiness in unit^-2 of weight, see above
  Fit solve(double steadiness);

 private:
  using Lanes = std::array<float, kLanes>;
  static constexpr std::size_t kMoments = 35;  ///< monomials of y up to the fourth degree

  void sum();

  double unit_;
  std::size_t used_ = 0;
  alignas(32) std::array<Lanes, 3> at_{}, normal_{};
  alignas(32) Lanes weight_{}, target_{};
  alignas(32) std::array<Lanes, kMoments> moments_{};
  alignas(32) std::array<Lanes, kTerms> targets_{};
  alignas(32) std::array<Lanes, 12> normals_{};  ///< w n, then w n_a y_b by a, b
};

}  // namespace angiomesh

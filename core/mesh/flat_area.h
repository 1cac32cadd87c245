// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace angiomesh {

/// Diameter of the circle of an area.
inline double equivalentDiameterMm(double areaMm2) {
  return std::sqrt(4.0 * areaMm2 / std::numbers::pi);
}

/// The area inside edges in one plane that run around it counter-clockwise, seen against the
/// normal.
class FlatArea {
 public:
  explicit FlatArea(const Eigen::Vector3d& normal) : normal_(normal) {}

  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    // About a point of the rim: coordinates of patients may be large.
    if (!started_) about_ = a;
    started_ = true;
    const double twice = normal_.dot((a - about_).cross(b - about_));
    area_ += 0.5 * twice;
    first_ += twice / 6.0 * (a + b - 2.0 * about_);
  }

  /// In the square of the points' unit; negative where the edges run clockwise.
  [[nodiscard]] double areaMm2() const { return area_; }
  /// Of the area, which must not be 0.
  [[nodiscard]] Eigen::Vector3d centre() const { return about_ + first_ / area_; }
  [[nodiscard]] const Eigen::Vector3d& normal() const { return normal_; }

 private:
  Eigen::Vector3d normal_, about_{0.0, 0.0, 0.0}, first_{0.0, 0.0, 0.0};
  double area_ = 0.0;
  bool started_ = false;
};

}  // namespace angiomesh

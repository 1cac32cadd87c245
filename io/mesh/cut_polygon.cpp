// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/cut_polygon.h"

#include <Eigen/Geometry>
#include <cstddef>

#include "core/mesh/predicates.h"

namespace angiomesh {
namespace {

/// Tests of a corner against an ear: a second's work. Outlines that wind need many.
constexpr std::size_t kMostTests = 300'000'000;

Eigen::Vector3d twiceAreaOf(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  for (std::size_t c = 1; c + 1 < corners.size(); ++c)
    twice += (corners[c] - corners[0]).cross(corners[c + 1] - corners[0]);
  return twice;
}

class EarCutter {
 public:
  explicit EarCutter(const std::vector<Eigen::Vector3d>& corners) : corners_(corners) {
    const Eigen::Vector3d normal = twiceAreaOf(corners).normalized();
    const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
      const Eigen::Vector3d from = corners[c] - corners[0];
      flat_.emplace_back(from.dot(u), from.dot(v));
      ring_.push_back(c);
    }
  }

  CornerTriangles cut() {
    CornerTriangles triangles;
    std::size_t at = 0;
    while (ring_.size() > 3) {
      if (!findEar(at, false) && !findEar(at, true)) return {};
      const std::size_t count = ring_.size();
      triangles.push_back({ring_[(at + count - 1) % count], ring_[at], ring_[(at + 1) % count]});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
      // Two on, or the triangles would be a fan about one corner.
      at = (at + 1) % ring_.size();
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
    return triangles;
  }

 private:
  bool findEar(std::size_t& at, bool flatToo) {
    const std::size_t count = ring_.size();
    for (std::size_t step = 0; step < count && tests_ < kMostTests; ++step) {
      const std::size_t place = (at + step) % count;
      if (!isEar(place, flatToo)) continue;
      at = place;
      return true;
    }
    return false;
  }

  bool isEar(std::size_t place, bool flatToo) {
    const std::size_t count = ring_.size();
    const std::uint32_t a = ring_[(place + count - 1) % count], b = ring_[place],
                        c = ring_[(place + 1) % count];
    const int turn = orient2d(flat_[a], flat_[b], flat_[c]);
    // Without an area nothing can lie in it.
    if (turn <= 0) return flatToo && turn == 0;
    for (const std::uint32_t p : ring_) {
      ++tests_;
      if (p == a || p == b || p == c || isAt(p, a) || isAt(p, b) || isAt(p, c)) continue;
      if (orient2d(flat_[a], flat_[b], flat_[p]) >= 0 &&
          orient2d(flat_[b], flat_[c], flat_[p]) >= 0 &&
          orient2d(flat_[c], flat_[a], flat_[p]) >= 0)
        return false;
    }
    return true;
  }

  [[nodiscard]] bool isAt(std::uint32_t p, std::uint32_t q) const {
    return corners_[p] == corners_[q];
  }

  const std::vector<Eigen::Vector3d>& corners_;
  std::vector<Eigen::Vector2d> flat_;
  std::vector<std::uint32_t> ring_;
  std::size_t tests_ = 0;
};

}  // namespace

CornerTriangles cutByEars(const std::vector<Eigen::Vector3d>& corners) {
  if (corners.size() < 3 || !(twiceAreaOf(corners).norm() > 0.0)) return {};
  CornerTriangles triangles = EarCutter(corners).cut();
  if (foldsOver(corners, triangles)) triangles.clear();
  return triangles;
}

bool foldsOver(const std::vector<Eigen::Vector3d>& corners, const CornerTriangles& triangles) {
  double around = 0.0;
  for (std::size_t c = 0; c < corners.size(); ++c)
    around += (corners[c] - corners[(c + 1) % corners.size()]).norm();
  // Rounding of corners in single precision, far from the origin, makes as much.
  const double nothing = 1e-9 * around * around;
  const Eigen::Vector3d twice = twiceAreaOf(corners);
  const Eigen::Vector3d normal = twice / std::max(twice.norm(), nothing);
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d area = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
    if (area.dot(normal) < -nothing) return true;
  }
  return false;
}

}  // namespace angiomesh

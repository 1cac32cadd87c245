// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace angiomesh {

/// Gives equal points one number: an STL file repeats each point in every triangle.
class PointMerger {
 public:
  explicit PointMerger(std::vector<Eigen::Vector3d>& points) : points_(points) {}

  std::uint32_t add(double x, double y, double z) {
    if (2 * points_.size() >= table_.size()) grow();
    // + 0.0 makes -0 and 0 the same bits.
    const Eigen::Vector3d point(x + 0.0, y + 0.0, z + 0.0);
    std::uint32_t& place = placeOf(point);
    if (place == kFree) {
      place = static_cast<std::uint32_t>(points_.size());
      points_.push_back(point);
    }
    return place;
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;

  static std::size_t hash(const Eigen::Vector3d& p) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (int axis = 0; axis < 3; ++axis) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &p[axis], sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }

  /// Where the table has the point, or may take it.
  std::uint32_t& placeOf(const Eigen::Vector3d& point) {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = hash(point) & mask;
    while (table_[at] != kFree && points_[table_[at]] != point) at = (at + 1) & mask;
    return table_[at];
  }

  void grow() {
    table_.assign(table_.empty() ? 1024 : 4 * table_.size(), kFree);
    for (std::size_t n = 0; n < points_.size(); ++n)
      placeOf(points_[n]) = static_cast<std::uint32_t>(n);
  }

  std::vector<Eigen::Vector3d>& points_;
  std::vector<std::uint32_t> table_;  ///< numbers of points from where their hash says on
};

}  // namespace angiomesh

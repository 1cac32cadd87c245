// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

namespace angiomesh {

/// Gives equal points one number: an STL file repeats each point in every triangle.
class PointMerger {
 public:
  explicit PointMerger(std::vector<Eigen::Vector3d>& points) : points_(points) {}

  std::uint32_t add(double x, double y, double z) {
    // + 0.0 makes -0 and 0 the same bits.
    const std::array<double, 3> key{x + 0.0, y + 0.0, z + 0.0};
    const auto [entry, isNew] = index_.emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (isNew) points_.emplace_back(key[0], key[1], key[2]);
    return entry->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& p) const {
      std::uint64_t hash = 0xcbf29ce484222325U;
      for (const double x : p) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof(bits));
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
      }
      return static_cast<std::size_t>(hash);
    }
  };

  std::vector<Eigen::Vector3d>& points_;
  std::unordered_map<std::array<double, 3>, std::uint32_t, Hash> index_;
};

}  // namespace angiomesh

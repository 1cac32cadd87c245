// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiomesh {

/// Points of very different spacing, found by position: a hash of cubic cells whose size follows
/// the length that each point is entered with (powers of two), so that a query costs about the same
/// everywhere. The order of a query's answers depends only on the insertions and removals before.
class PointGrid {
 public:
  PointGrid() : heads_(1024, none) {}

  void reserve(std::size_t points) { chunks_.reserve(points / 2); }

  /// `id` must not be in the grid; `length` > 0 is about the distance to its neighbours.
  void insert(std::uint32_t id, const Eigen::Vector3d& point, double length);
  /// With the point and the length that it was entered with.
  void remove(std::uint32_t id, const Eigen::Vector3d& point, double length);

  /// Calls visit(id) for the points within `radius` of `centre`; those entered with a length below
  /// `shortest` may be left out.
  template <class Visit>
  void forEachNear(const Eigen::Vector3d& centre, double radius, double shortest,
                   Visit visit) const {
    const int from = shortest > 0.0 ? std::max(lowest_, levelOf(shortest)) : lowest_;
    for (int level = from; level <= highest_; ++level) {
      if (onLevel_[static_cast<std::size_t>(level)] == 0) continue;
      const double inverse = 1.0 / cellSize(level);
      std::array<std::int64_t, 3> low{}, high{};
      for (int a = 0; a < 3; ++a) {
        low[static_cast<std::size_t>(a)] =
            static_cast<std::int64_t>(std::floor((centre[a] - radius) * inverse));
        high[static_cast<std::size_t>(a)] =
            static_cast<std::int64_t>(std::floor((centre[a] + radius) * inverse));
      }
      for (std::int64_t k = low[2]; k <= high[2]; ++k)
        for (std::int64_t j = low[1]; j <= high[1]; ++j)
          for (std::int64_t i = low[0]; i <= high[0]; ++i)
            visitCell(keyOf(level, i, j, k), centre, radius, visit);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr int kLevels = 127, kUnitLevel = 64;
  static constexpr std::uint32_t kChunk = 4;
  static constexpr std::size_t kBuckets = 4;  ///< per chunk: most of what is asked for is not there

  /// Some of the points of one cell, together in memory.
  struct alignas(64) Chunk {
    std::uint64_t key = 0;
    std::uint32_t next = none;  ///< of the bucket, which may be of another cell
    std::uint32_t count = 0;
    std::array<std::uint32_t, kChunk> ids{};
    std::array<Eigen::Vector3d, kChunk> points;
  };

  // Cells of four to eight lengths: a query of two lengths then meets few of them, also of those
  // for shorter lengths, most of which are empty.
  static int levelOf(double length) {
    return std::clamp(std::ilogb(length) + 3 + kUnitLevel, 0, kLevels - 1);
  }
  static double cellSize(int level) { return std::ldexp(1.0, level - kUnitLevel); }
  // Cells 2^19 apart share a key: the distance tells them apart.
  static std::uint64_t keyOf(int level, std::int64_t i, std::int64_t j, std::int64_t k) {
    constexpr std::uint64_t mask = (1ULL << 19U) - 1;
    return (static_cast<std::uint64_t>(level) << 57U) |
           ((static_cast<std::uint64_t>(k) & mask) << 38U) |
           ((static_cast<std::uint64_t>(j) & mask) << 19U) | (static_cast<std::uint64_t>(i) & mask);
  }
  static int levelOfKey(std::uint64_t key) { return static_cast<int>(key >> 57U); }
  static std::uint64_t keyAt(const Eigen::Vector3d& point, double length);
  // Four cells in a row have neighbouring buckets.
  [[nodiscard]] std::size_t bucket(std::uint64_t key) const {
    std::uint64_t h = (key >> 2U) * 0xff51afd7ed558ccdULL;
    h ^= h >> 32U;
    h *= 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>((h >> 24U << 2U) | (key & 3U)) & (heads_.size() - 1);
  }
  template <class Visit>
  void visitCell(std::uint64_t key, const Eigen::Vector3d& centre, double radius,
                 Visit& visit) const {
    for (std::uint32_t c = heads_[bucket(key)]; c != none; c = chunks_[c].next) {
      const Chunk& chunk = chunks_[c];
      if (chunk.key != key) continue;
      for (std::uint32_t n = 0; n < chunk.count; ++n)
        if ((chunk.points[n] - centre).squaredNorm() <= radius * radius) visit(chunk.ids[n]);
    }
  }
  std::uint32_t newChunk(std::uint64_t key);
  void link(std::uint32_t c);
  void grow();

  std::vector<std::uint32_t> heads_;
  std::vector<Chunk> chunks_;
  std::uint32_t free_ = none;  ///< the first of the chunks that hold nothing
  std::array<std::uint32_t, kLevels> onLevel_{};
  int lowest_ = kLevels, highest_ = -1;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// The voxels of a sparse set, numbered in order of memory, found again by position. Memory goes
/// with the set and the rows of the grid, not with its voxels.
class VoxelSet {
 public:
  /// The voxels labelled 1..lastLabel.
  VoxelSet(const Volume<std::int32_t>& labels, std::int32_t lastLabel);

  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  [[nodiscard]] std::size_t voxel(std::size_t n) const { return voxels_[n]; }
  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  [[nodiscard]] Index3 indexOf(std::size_t n) const { return geometry_.indexOf(voxels_[n]); }
  /// Of the voxel's centre, mm along the axes of the grid.
  [[nodiscard]] Eigen::Vector3d position(std::size_t n) const {
    const Index3 p = indexOf(n);
    return geometry_.spacing.cwiseProduct(Eigen::Vector3d(p[0], p[1], p[2]));
  }

  /// The voxel around a position in mm along the axes of the grid, if the set holds it.
  [[nodiscard]] std::optional<std::uint32_t> numberAt(const Eigen::Vector3d& position) const;

  /// Calls visit(number, index) for the voxels of the set in row (j, k) from i0 to i1.
  template <class F>
  void forRow(int i0, int i1, int j, int k, F visit) const {
    if (j < 0 || k < 0 || j >= geometry_.size[1] || k >= geometry_.size[2]) return;
    const std::size_t row =
        static_cast<std::size_t>(j) +
        static_cast<std::size_t>(k) * static_cast<std::size_t>(geometry_.size[1]);
    const auto base = static_cast<std::int64_t>(geometry_.offset(0, j, k));
    const auto begin = voxels_.begin() + static_cast<std::ptrdiff_t>(rowStart_[row]);
    const auto end = voxels_.begin() + static_cast<std::ptrdiff_t>(rowStart_[row + 1]);
    auto at = std::lower_bound(begin, end, base + i0,
                               [](std::uint32_t a, std::int64_t b) { return a < b; });
    for (; at != end && *at <= base + i1; ++at)
      visit(static_cast<std::size_t>(at - voxels_.begin()), static_cast<int>(*at - base));
  }

  /// Calls visit(number, length) for the 26 neighbours of voxel n, `length` the distance in mm.
  template <class F>
  void forNeighbours(std::size_t n, F visit) const {
    const Index3 p = indexOf(n);
    for (int dk = -1; dk <= 1; ++dk)
      for (int dj = -1; dj <= 1; ++dj)
        forRow(p[0] - 1, p[0] + 1, p[1] + dj, p[2] + dk, [&](std::size_t next, int i) {
          if (next == n) return;
          visit(next,
                lengths_[static_cast<std::size_t>((i != p[0]) + 2 * (dj != 0) + 4 * (dk != 0))]);
        });
  }

 private:
  Geometry geometry_;
  std::vector<std::uint32_t> voxels_;
  std::vector<std::uint32_t> rowStart_;
  std::array<double, 8> lengths_{};  ///< of steps along the axes whose bits are set
};

}  // namespace angiomesh

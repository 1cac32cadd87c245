// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/image/volume.h"

namespace angiomesh {

/// The steps from a voxel to those of the 3 x 3 x 3 around it, in order of memory: number
/// i + 3 j + 9 k goes to (i - 1, j - 1, k - 1), and kMiddle27 stays.
inline constexpr std::array<Index3, 27> kSteps27 = [] {
  std::array<Index3, 27> steps{};
  for (int n = 0; n < 27; ++n)
    steps[static_cast<std::size_t>(n)] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
  return steps;
}();
inline constexpr std::size_t kMiddle27 = 13;

/// Calls visit(number, voxel) for a voxel of a grid and its 26 neighbours, without those that lie
/// beyond the border, in order of memory.
template <class Visit>
void forAround(const Geometry& g, std::size_t voxel, Visit visit) {
  const Index3 p = g.indexOf(voxel);
  const bool inner = p[0] > 0 && p[1] > 0 && p[2] > 0 && p[0] + 1 < g.size[0] &&
                     p[1] + 1 < g.size[1] && p[2] + 1 < g.size[2];
  const std::int64_t row = g.size[0], slice = row * g.size[1];
  for (std::size_t n = 0; n < kSteps27.size(); ++n) {
    const Index3& d = kSteps27[n];
    if (!inner && !g.contains(p[0] + d[0], p[1] + d[1], p[2] + d[2])) continue;
    visit(n, static_cast<std::size_t>(static_cast<std::int64_t>(voxel) + d[0] + row * d[1] +
                                      slice * d[2]));
  }
}

/// The same for the neighbours alone.
template <class Visit>
void forNeighbours(const Geometry& g, std::size_t voxel, Visit visit) {
  forAround(g, voxel, [&](std::size_t n, std::size_t next) {
    if (n != kMiddle27) visit(n, next);
  });
}

/// Calls visit(voxel) for the up to 6 neighbours across a face, along x first.
template <class Voxel, class Visit>
void forFaceNeighbours(const Geometry& g, Voxel voxel, Visit visit) {
  const Index3 p = g.indexOf(voxel);
  const auto row = static_cast<Voxel>(g.size[0]);
  const auto slice = static_cast<Voxel>(g.offset(0, 0, 1));
  if (p[0] > 0) visit(voxel - 1);
  if (p[0] + 1 < g.size[0]) visit(voxel + 1);
  if (p[1] > 0) visit(voxel - row);
  if (p[1] + 1 < g.size[1]) visit(voxel + row);
  if (p[2] > 0) visit(voxel - slice);
  if (p[2] + 1 < g.size[2]) visit(voxel + slice);
}

inline Eigen::Vector3d voxelCentre(const Geometry& g, const Index3& p) {
  return g.toPhysical({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]});
}
inline Eigen::Vector3d voxelCentre(const Geometry& g, std::size_t voxel) {
  return voxelCentre(g, g.indexOf(voxel));
}

/// The voxel whose centre is nearest to a point, half-way away from voxel (0, 0, 0)'s; it may lie
/// beyond the border.
inline Index3 nearestVoxel(const Geometry& g, const Eigen::Vector3d& pointLps) {
  const Eigen::Vector3d index = g.toIndex(pointLps);
  return {static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
          static_cast<int>(std::lround(index[2]))};
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/component_points.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

namespace angiomesh {

namespace {

std::optional<Index3> voxelAt(const Geometry& grid, const Eigen::Vector3d& lps) {
  const Eigen::Vector3d index = grid.toIndex(lps);
  const Index3 voxel{static_cast<int>(std::lround(index[0])),
                     static_cast<int>(std::lround(index[1])),
                     static_cast<int>(std::lround(index[2]))};
  if (!grid.contains(voxel[0], voxel[1], voxel[2])) {
    return std::nullopt;
  }
  return voxel;
}

}  // namespace

std::vector<std::size_t> pointsInComponent(const Volume<float>& phi, const Eigen::Vector3d& inner,
                                           const std::vector<double>& points) {
  const Geometry& grid = phi.geometry;
  std::vector<std::pair<std::size_t, std::size_t>> wanted;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    if (const auto v = voxelAt(grid, {points[i], points[i + 1], points[i + 2]})) {
      wanted.emplace_back(grid.offset((*v)[0], (*v)[1], (*v)[2]), i / 3);
    }
  }
  const auto start = voxelAt(grid, inner);
  if (wanted.empty() || !start) {
    return {};
  }
  std::vector<std::size_t> front{grid.offset((*start)[0], (*start)[1], (*start)[2])};
  std::unordered_set<std::size_t> reached(front.begin(), front.end());
  while (!front.empty()) {
    const Index3 at = grid.indexOf(front.back());
    front.pop_back();
    for (int n = 0; n < 27; ++n) {
      const int i = at[0] + n % 3 - 1;
      const int j = at[1] + n / 3 % 3 - 1;
      const int k = at[2] + n / 9 - 1;
      if (grid.contains(i, j, k) && phi.at(i, j, k) < 0.0F &&
          reached.insert(grid.offset(i, j, k)).second) {
        front.push_back(grid.offset(i, j, k));
      }
    }
  }
  std::vector<std::size_t> found;
  for (const auto& [offset, point] : wanted) {
    if (reached.count(offset) != 0) {
      found.push_back(point);
    }
  }
  return found;
}

}  // namespace angiomesh

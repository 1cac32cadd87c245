// SPDX-License-Identifier: BSD-3-Clause
#include "core/image/volume.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/image/voxels.h"

namespace angiomesh {

Eigen::Matrix3d Geometry::physicalToIndexMatrix() const {
  return spacing.cwiseInverse().asDiagonal() * direction.inverse();
}

Eigen::Vector3d Geometry::toIndex(const Eigen::Vector3d& pointLps) const {
  return physicalToIndexMatrix() * (pointLps - origin);
}

bool Geometry::holds(const Eigen::Vector3d& pointLps, double toleranceVoxels) const {
  const Eigen::Vector3d index = toIndex(pointLps);
  for (int a = 0; a < 3; ++a)
    if (!(index[a] >= -toleranceVoxels &&
          index[a] <= size[static_cast<std::size_t>(a)] - 1.0 + toleranceVoxels))
      return false;
  return true;
}

bool Geometry::operator==(const Geometry& other) const {
  const double tolerance = 1e-5;
  return size == other.size && (spacing - other.spacing).cwiseAbs().maxCoeff() < tolerance &&
         (origin - other.origin).cwiseAbs().maxCoeff() < tolerance * 100 &&
         (direction - other.direction).cwiseAbs().maxCoeff() < tolerance;
}

double interpolateLinear(const Volume<float>& image, const Eigen::Vector3d& index) {
  const Geometry& g = image.geometry;
  int low[3];
  int high[3];
  double t[3];
  for (int a = 0; a < 3; ++a) {
    const double x = std::clamp(index[a], 0.0, static_cast<double>(g.size[a] - 1));
    low[a] = static_cast<int>(x);
    high[a] = std::min(low[a] + 1, g.size[a] - 1);
    t[a] = x - low[a];
  }
  const auto along = [&](int j, int k) {
    const double v0 = image.at(low[0], j, k);
    return v0 + t[0] * (static_cast<double>(image.at(high[0], j, k)) - v0);
  };
  const double v00 = along(low[1], low[2]);
  const double v10 = along(high[1], low[2]);
  const double v01 = along(low[1], high[2]);
  const double v11 = along(high[1], high[2]);
  const double v0 = v00 + t[1] * (v10 - v00);
  const double v1 = v01 + t[1] * (v11 - v01);
  return v0 + t[2] * (v1 - v0);
}

Volume<std::uint8_t> insideMask(const Volume<float>& phi) {
  Volume<std::uint8_t> mask(phi.geometry);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) mask.voxels[i] = phi.voxels[i] < 0.0F ? 1 : 0;
  return mask;
}

double shareOfBorder(const Volume<std::uint8_t>& mask) {
  const Index3& n = mask.geometry.size;
  std::size_t all = 0, set = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j) {
      const bool inner = k > 0 && k < n[2] - 1 && j > 0 && j < n[1] - 1;
      for (int i = 0; i < n[0]; i += inner ? std::max(n[0] - 1, 1) : 1) {
        ++all;
        set += mask.at(i, j, k) != 0 ? 1 : 0;
      }
    }
  return static_cast<double>(set) / static_cast<double>(std::max<std::size_t>(all, 1));
}

Components connectedComponents(const Volume<std::uint8_t>& mask, bool fullyConnected) {
  Components result{Volume<std::int32_t>(mask.geometry), {}};
  BigVector<std::int32_t>& labels = result.labels.voxels;
  std::vector<std::size_t> stack;
  std::vector<std::size_t> sizes;
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (mask.voxels[seed] == 0 || labels[seed] != 0) continue;
    const auto label = static_cast<std::int32_t>(sizes.size() + 1);
    std::size_t count = 0;
    labels[seed] = label;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::size_t at = stack.back();
      stack.pop_back();
      ++count;
      forNeighbours(mask.geometry, at, [&](std::size_t n, std::size_t next) {
        const Index3& d = kSteps27[n];
        if (!fullyConnected && std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) != 1) return;
        if (mask.voxels[next] == 0 || labels[next] != 0) return;
        labels[next] = label;
        stack.push_back(next);
      });
    }
    sizes.push_back(count);
  }
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<std::int32_t> rank(sizes.size() + 1, 0);
  for (std::size_t r = 0; r < order.size(); ++r) {
    rank[order[r] + 1] = static_cast<std::int32_t>(r + 1);
    result.sizes.push_back(sizes[order[r]]);
  }
  for (std::int32_t& label : labels) label = rank[static_cast<std::size_t>(label)];
  return result;
}

}  // namespace angiomesh

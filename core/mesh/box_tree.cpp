// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/box_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/base/parallel.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 4096;
constexpr int kKeyBits = 10;  // for each axis

// The low ten bits, two zeros after each.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16U)) & 0x030000ffU;
  x = (x | (x << 8U)) & 0x0300f00fU;
  x = (x | (x << 4U)) & 0x030c30c3U;
  return (x | (x << 2U)) & 0x09249249U;
}

// Sorts by the upper 32 bits, of which 30 are used; equal ones keep their order.
void sortByKey(std::vector<std::uint64_t>& items) {
  constexpr std::uint64_t mask = (1U << kKeyBits) - 1;
  std::vector<std::uint64_t> sorted(items.size());
  for (int pass = 0; pass < 3; ++pass) {
    const int shift = 32 + kKeyBits * pass;
    std::array<std::size_t, mask + 2> start{};
    for (const std::uint64_t item : items) ++start[((item >> shift) & mask) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const std::uint64_t item : items) sorted[start[(item >> shift) & mask]++] = item;
    items.swap(sorted);
  }
}

}  // namespace

BoxTree::BoxTree(const TriMesh& mesh, const Progress& progress) : mesh_(mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(p);
  if (!mesh.points.empty()) corner_ = box.min();
  sort(mesh.points.empty() ? 0.0 : box.sizes().maxCoeff(), progress);
  measure(progress);
}

// Along Morton's curve through the middles of the triangles' boxes.
void BoxTree::sort(double extent, const Progress& progress) {
  const std::size_t count = mesh_.triangles.size();
  constexpr double last = (1U << kKeyBits) - 1;
  const double perMm = extent > 0.0 ? (last + 1.0) / extent : 0.0;
  std::vector<std::uint64_t> items(count);
  parallelForEach(count, blockSize, progress, [&](std::size_t t) {
    const auto corners = cornersOf(mesh_, static_cast<std::uint32_t>(t));
    const Eigen::Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Eigen::Vector3d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = perMm * (0.5 * (low[axis] + high[axis]) - corner_[axis]);
      const auto cell = static_cast<std::uint32_t>(x > 0.0 ? std::min(x, last) : 0.0);
      key |= std::uint64_t{spread(cell)} << axis;
    }
    items[t] = key << 32U | t;
  });
  sortByKey(items);
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) order_[i] = static_cast<std::uint32_t>(items[i]);
}

void BoxTree::measure(const Progress& progress) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto nodesFor = [](std::size_t boxes) { return (boxes + kWidth - 1) / kWidth; };
  Boxes none{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    none.low[axis].fill(infinity);
    none.high[axis].fill(-infinity);
  }
  levels_.emplace_back(nodesFor(order_.size()), none);
  parallelFor(0, levels_[0].size(), blockSize / kWidth, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t i = kWidth * first; i < std::min(kWidth * last, order_.size()); ++i) {
      Boxes& boxes = levels_[0][i / kWidth];
      for (const std::uint32_t v : mesh_.triangles[order_[i]])
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto a = static_cast<Eigen::Index>(axis);
          const auto x = static_cast<float>(mesh_.points[v][a] - corner_[a]);
          boxes.low[axis][i % kWidth] = std::min(boxes.low[axis][i % kWidth], x);
          boxes.high[axis][i % kWidth] = std::max(boxes.high[axis][i % kWidth], x);
        }
    }
  });
  do {
    const std::vector<Boxes>& below = levels_.back();
    std::vector<Boxes> level(std::max<std::size_t>(nodesFor(below.size()), 1), none);
    for (std::size_t i = 0; i < below.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Boxes& boxes = level[i / kWidth];
        const auto& low = below[i].low[axis];
        const auto& high = below[i].high[axis];
        boxes.low[axis][i % kWidth] = *std::min_element(low.begin(), low.end());
        boxes.high[axis][i % kWidth] = *std::max_element(high.begin(), high.end());
      }
    levels_.push_back(std::move(level));
  } while (levels_.back().size() > 1);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <limits>

#include "core/surface/advancing_front.h"
#include "core/surface/wall_smoother.h"

namespace angiomesh {
namespace {

// Longer loops than this are not filled: the work grows with the third power.
constexpr std::size_t kLongestLoop = 256;

}  // namespace

// Triangulates one loop by dynamic programming: weight(i, k) = least over m of weight(i, m) +
// weight(m, k) + that of the triangle (i, m, k).
bool AdvancingFront::fill(const std::vector<std::uint32_t>& loop) {
  const std::size_t n = loop.size();
  if (n < 3 || n > kLongestLoop) return n == 2;
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto cell = [n](std::size_t i, std::size_t k) { return i * n + k; };
  std::vector<double> weight(n * n, never);
  std::vector<std::uint32_t> best(n * n, none);
  const auto usable = [&](std::size_t i, std::size_t k) {
    if (k == i + 1 || (i == 0 && k + 1 == n)) return true;
    return loop[i] != loop[k] && !used_.has(loop[i], loop[k]) && !used_.has(loop[k], loop[i]);
  };
  const auto cost = [&](std::size_t i, std::size_t m, std::size_t k) {
    const FrontPoint &a = vertices_[loop[i]], &b = vertices_[loop[m]], &c = vertices_[loop[k]];
    const Eigen::Vector3d normal = (b.point - a.point).cross(c.point - a.point);
    const double area = normal.norm();
    if (!(area > 0.0)) return never;
    const double fold = 1.0 - normal.dot(a.normal + b.normal + c.normal) / (3.0 * area);
    return area * (1.0 + 20.0 * fold * fold) / (1.001 - largestCosine(a.point, b.point, c.point));
  };
  for (std::size_t i = 0; i + 1 < n; ++i) weight[cell(i, i + 1)] = 0.0;
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t k = i + span;
      if (!usable(i, k)) continue;
      for (std::size_t m = i + 1; m < k; ++m) {
        const double parts = weight[cell(i, m)] + weight[cell(m, k)];
        if (!(parts < weight[cell(i, k)])) continue;
        const double sum = parts + cost(i, m, k);
        if (sum < weight[cell(i, k)]) {
          weight[cell(i, k)] = sum;
          best[cell(i, k)] = static_cast<std::uint32_t>(m);
        }
      }
    }
  }
  if (weight[cell(0, n - 1)] == never) return false;
  std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k == i + 1) continue;
    const std::size_t m = best[cell(i, k)];
    addTriangle({loop[i], loop[m], loop[k]}, FaceOrigin::Closing);
    open.push_back({i, m});
    open.push_back({m, k});
  }
  return true;
}

std::size_t AdvancingFront::close() {
  std::size_t failed = 0;
  for (std::uint32_t id = 0; id < edges_.size(); ++id) {
    if (!edges_[id].alive) continue;
    std::vector<std::uint32_t> loop, members;
    for (std::uint32_t h = id;;) {
      loop.push_back(edges_[h].from);
      members.push_back(h);
      h = edges_[h].next;
      if (h == id) break;
    }
    if (!fill(loop)) ++failed;
    for (const std::uint32_t h : members) dropEdge(h);
  }
  return failed;
}

}  // namespace angiomesh

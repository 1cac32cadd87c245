// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/fill_loop.h"

#include <Eigen/Geometry>
#include <limits>

#include "core/mesh/triangle_shape.h"

namespace angiomesh {
namespace {

// The work grows with the third power.
constexpr std::size_t kLongestLoop = 256;
/// How much a triangle that turns away from the normals weighs more than its area; and what keeps
/// one without an angle from weighing all.
constexpr double kFoldWeight = 20.0, kSharpest = 1.001;
constexpr double kNever = std::numeric_limits<double>::infinity();

double weightOf(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c) {
  const Eigen::Vector3d normal = (b.point - a.point).cross(c.point - a.point);
  const double area = normal.norm();
  if (!(area > 0.0)) return kNever;
  const double fold = 1.0 - normal.dot(a.normal + b.normal + c.normal) / (3.0 * area);
  return area * (1.0 + kFoldWeight * fold * fold) /
         (kSharpest - largestCosine(a.point, b.point, c.point));
}

}  // namespace

// weight(i, k) = least over m of weight(i, m) + weight(m, k) + that of the triangle (i, m, k).
std::vector<std::array<std::uint32_t, 3>> fillLoop(
    const std::vector<std::uint32_t>& loop, const std::vector<FrontPoint>& vertices,
    const std::function<bool(std::uint32_t, std::uint32_t)>& taken) {
  const std::size_t n = loop.size();
  if (n < 3 || n > kLongestLoop) return {};
  const auto cell = [n](std::size_t i, std::size_t k) { return i * n + k; };
  std::vector<double> weight(n * n, kNever);
  std::vector<std::uint32_t> best(n * n, 0);
  const auto usable = [&](std::size_t i, std::size_t k) {
    if (k == i + 1 || (i == 0 && k + 1 == n)) return true;
    return loop[i] != loop[k] && !taken(loop[i], loop[k]);
  };
  for (std::size_t i = 0; i + 1 < n; ++i) weight[cell(i, i + 1)] = 0.0;
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t k = i + span;
      if (!usable(i, k)) continue;
      for (std::size_t m = i + 1; m < k; ++m) {
        const double parts = weight[cell(i, m)] + weight[cell(m, k)];
        if (!(parts < weight[cell(i, k)])) continue;
        const double sum =
            parts + weightOf(vertices[loop[i]], vertices[loop[m]], vertices[loop[k]]);
        if (sum < weight[cell(i, k)]) {
          weight[cell(i, k)] = sum;
          best[cell(i, k)] = static_cast<std::uint32_t>(m);
        }
      }
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (weight[cell(0, n - 1)] == kNever) return triangles;
  std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k == i + 1) continue;
    const std::size_t m = best[cell(i, k)];
    triangles.push_back({loop[i], loop[m], loop[k]});
    open.push_back({i, m});
    open.push_back({m, k});
  }
  return triangles;
}

}  // namespace angiomesh

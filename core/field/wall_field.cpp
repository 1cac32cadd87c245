// SPDX-License-Identifier: BSD-3-Clause
#include "core/field/wall_field.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

// Working voxels: where d is smooth and tells the curvature, and where it is changed.
constexpr double kFirst = 0.3, kLast = 2.0, kDeepest = 4.0, kFarthest = 4.8;
// Depths of ridges from which on d is changed less, and not at all.
constexpr double kThin = 2.5, kThick = 3.5;
// Outside, from where on the change grows in proportion, falls, and is none.
constexpr double kStraight = 1.5, kFull = 2.0, kNone = 5.0;
constexpr double kSharpest = 0.7;  // radius of curvature
constexpr int kReach = 3;          // voxels around, over which curvatures are averaged
/// Gaussian of 1.2 voxels.
constexpr double kWeight[kReach + 1] = {1.0, 0.7066482778577162, 0.24935220877729622,
                                        0.04393693362340742};

/// A voxel outside, next to a wall, by its place in its row.
struct Outside {
  int column;
  float sum, product;  ///< of the wall's principal curvatures beneath it, per working voxel
};

/// Of the curvatures around a voxel. Their larger one is taken from the means: the mean of larger
/// ones would be too large where the wall is rough.
struct Mean {
  double sum = 0.0, product = 0.0, weight = 0.0;

  [[nodiscard]] double larger() const {
    const double half = 0.5 * sum / weight;
    const double root = std::sqrt(std::max(0.0, half * half - product / weight));
    return std::clamp(half + root, 0.0, 1.0 / kSharpest);
  }
};

class RidgeRounder {
 public:
  explicit RidgeRounder(const Volume<float>& phi)
      : phi_(phi),
        grid_(phi.geometry),
        voxelMm_(grid_.voxelMm()),
        rows_(static_cast<std::size_t>(grid_.size[1]) * static_cast<std::size_t>(grid_.size[2])) {}

  Volume<float> run() {
    forRows([&](int j, int k) { measureRow(j, k); });
    Volume<float> result = phi_;
    forRows([&](int j, int k) { roundRow(j, k, result); });
    return result;
  }

 private:
  template <class Visit>
  void forRows(const Visit& visit) const {
    parallelFor(0, rows_.size(), 64, [&](std::size_t first, std::size_t last) {
      const auto ny = static_cast<std::size_t>(grid_.size[1]);
      for (std::size_t row = first; row < last; ++row)
        visit(static_cast<int>(row % ny), static_cast<int>(row / ny));
    });
  }

  std::vector<Outside>& row(int j, int k) {
    return rows_[static_cast<std::size_t>(j) +
                 static_cast<std::size_t>(grid_.size[1]) * static_cast<std::size_t>(k)];
  }

  void measureRow(int j, int k) {
    if (j < 1 || k < 1 || j + 1 >= grid_.size[1] || k + 1 >= grid_.size[2]) return;
    for (int i = 1; i + 1 < grid_.size[0]; ++i) {
      const double d = static_cast<double>(phi_.at(i, j, k)) / voxelMm_;
      if (d >= kFirst && d <= kLast) row(j, k).push_back(curvatures(i, j, k, d));
    }
  }

  /// Level sets of a distance are parallel: its curvatures at distance d tell the wall's.
  [[nodiscard]] Outside curvatures(int i, int j, int k, double d) const {
    const auto at = [&](int a, int b, int c) {
      return static_cast<double>(phi_.at(i + a, j + b, k + c)) / voxelMm_;
    };
    const Eigen::Vector3d step = grid_.spacing / voxelMm_;
    Eigen::Matrix3d hessian;
    for (int a = 0; a < 3; ++a) {
      Index3 one{};
      one[a] = 1;
      hessian(a, a) = (at(one[0], one[1], one[2]) - 2.0 * d + at(-one[0], -one[1], -one[2])) /
                      (step[a] * step[a]);
      const int b = (a + 1) % 3;
      Index3 plus = one, minus = one;
      plus[b] = 1;
      minus[b] = -1;
      hessian(a, b) = hessian(b, a) =
          (at(plus[0], plus[1], plus[2]) - at(minus[0], minus[1], minus[2]) -
           at(-minus[0], -minus[1], -minus[2]) + at(-plus[0], -plus[1], -plus[2])) /
          (4.0 * step[a] * step[b]);
    }
    // Of its eigenvalues that along the gradient is 0.
    const double sum = hessian.trace();
    const double product = hessian(0, 0) * hessian(1, 1) + hessian(1, 1) * hessian(2, 2) +
                           hessian(2, 2) * hessian(0, 0) - hessian(0, 1) * hessian(0, 1) -
                           hessian(1, 2) * hessian(1, 2) - hessian(0, 2) * hessian(0, 2);
    const double area = std::max(0.2, 1.0 - sum * d + product * d * d);
    return {i, static_cast<float>((sum - 2.0 * product * d) / area),
            static_cast<float>(product / area)};
  }

  void roundRow(int j, int k, Volume<float>& result) {
    std::vector<int> columns;
    for (int i = 0; i < grid_.size[0]; ++i) {
      const double d = static_cast<double>(phi_.at(i, j, k)) / voxelMm_;
      if (d > -kDeepest && d < kFarthest) columns.push_back(i);
    }
    if (columns.empty()) return;
    std::vector<Mean> means(columns.size());
    for (int c = std::max(0, k - kReach); c <= std::min(grid_.size[2] - 1, k + kReach); ++c)
      for (int b = std::max(0, j - kReach); b <= std::min(grid_.size[1] - 1, j + kReach); ++b) {
        const std::vector<Outside>& others = row(b, c);
        const double across = kWeight[std::abs(b - j)] * kWeight[std::abs(c - k)];
        std::size_t from = 0;
        for (std::size_t n = 0; n < columns.size(); ++n) {
          while (from < others.size() && others[from].column < columns[n] - kReach) ++from;
          for (std::size_t m = from; m < others.size() && others[m].column <= columns[n] + kReach;
               ++m) {
            const double w = across * kWeight[std::abs(others[m].column - columns[n])];
            means[n].sum += w * static_cast<double>(others[m].sum);
            means[n].product += w * static_cast<double>(others[m].product);
            means[n].weight += w;
          }
        }
      }
    for (std::size_t n = 0; n < columns.size(); ++n)
      if (means[n].weight > 0.0) round(result.at(columns[n], j, k), means[n].larger());
  }

  void round(float& value, double curvature) const {
    if (curvature * kThick <= 1.0) return;
    const double share = std::clamp((kThick - 1.0 / curvature) / (kThick - kThin), 0.0, 1.0);
    const double d = static_cast<double>(value) / voxelMm_;
    // From its turning point on, d + c d^2 / 2 stays at -1 / 2c.
    const double rounded =
        d < -1.0 / curvature ? -0.5 / curvature : d + curvature * (d < 0.0 ? 0.5 * d * d : rise(d));
    value += static_cast<float>(share * (rounded - d) * voxelMm_);
  }

  // d^2 / 2, then straight on, and back to 0.
  static double rise(double d) {
    const double near = std::min(d, kStraight);
    const double full = 0.5 * near * near + near * (d - near);
    const double turn = std::clamp((d - kFull) / (kNone - kFull), 0.0, 1.0);
    return full * (1.0 - turn * turn * (3.0 - 2.0 * turn));
  }

  const Volume<float>& phi_;
  const Geometry& grid_;
  double voxelMm_;
  std::vector<std::vector<Outside>> rows_;
};

}  // namespace

Volume<float> withRoundRidges(const Volume<float>& phi) { return RidgeRounder(phi).run(); }

SplineField wallField(const Volume<float>& phi, SplineKind kind) {
  return kind == SplineKind::Bspline ? SplineField(phi, kind)
                                     : SplineField(withRoundRidges(phi), kind);
}

}  // namespace angiomesh

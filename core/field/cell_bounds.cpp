// SPDX-License-Identifier: BSD-3-Clause
#include "core/field/cell_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiomesh {
namespace {

using Row = std::array<double, 4>;

// The cubic on one cell as Bezier points, from the four samples around it.
Row bezier(const Row& c, SplineKind kind) {
  if (kind == SplineKind::CatmullRom)
    return {c[1], c[1] + (c[2] - c[0]) / 6.0, c[2] - (c[3] - c[1]) / 6.0, c[2]};
  return {(c[0] + 4.0 * c[1] + c[2]) / 6.0, (2.0 * c[1] + c[2]) / 3.0, (c[1] + 2.0 * c[2]) / 3.0,
          (c[1] + 4.0 * c[2] + c[3]) / 6.0};
}

// The part of a Bezier cubic over [low, high], by its polar form (Ramshaw 1987).
Row restricted(const Row& b, double low, double high) {
  const auto polar = [&b](double r, double s, double t) {
    const auto mix = [](double x, double y, double u) { return x + u * (y - x); };
    const double p0 = mix(b[0], b[1], r), p1 = mix(b[1], b[2], r), p2 = mix(b[2], b[3], r);
    return mix(mix(p0, p1, s), mix(p1, p2, s), t);
  };
  return {polar(low, low, low), polar(low, low, high), polar(low, high, high),
          polar(high, high, high)};
}

struct Cube {
  std::array<double, 64> v;  // x runs fastest

  template <class Change>
  void alongAxis(int axis, Change change) {
    const std::size_t step = axis == 0 ? 1 : axis == 1 ? 4 : 16;
    const std::size_t u = axis == 0 ? 4 : 1, w = axis == 2 ? 4 : 16;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = 0; q < 4; ++q) {
        double* line = v.data() + p * u + q * w;
        const Row row = change(Row{line[0], line[step], line[2 * step], line[3 * step]});
        for (std::size_t i = 0; i < 4; ++i) line[i * step] = row[i];
      }
    }
  }
  [[nodiscard]] double at(std::size_t i, std::size_t j, std::size_t k) const {
    return v[i + 4 * j + 16 * k];
  }
};

// Largest second difference along one axis.
double straight(const Cube& c, int axis) {
  const std::size_t step = axis == 0 ? 1 : axis == 1 ? 4 : 16;
  const std::size_t u = axis == 0 ? 4 : 1, w = axis == 2 ? 4 : 16;
  double most = 0.0;
  for (std::size_t p = 0; p < 4; ++p)
    for (std::size_t q = 0; q < 4; ++q) {
      const double* line = c.v.data() + p * u + q * w;
      for (std::size_t i = 0; i < 2; ++i)
        most = std::max(
            most, std::fabs(line[i * step] - 2.0 * line[(i + 1) * step] + line[(i + 2) * step]));
    }
  return 6.0 * most;
}

// Largest mixed difference of two axes.
double mixed(const Cube& c, int axis, int other) {
  const auto stepOf = [](int a) -> std::size_t { return a == 0 ? 1 : a == 1 ? 4 : 16; };
  const std::size_t s = stepOf(axis), t = stepOf(other), w = stepOf(3 - axis - other);
  double most = 0.0;
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double* p = c.v.data() + r * w + i * s + j * t;
        most = std::max(most, std::fabs(p[s + t] - p[s] - p[t] + p[0]));
      }
  return 9.0 * most;
}

// The control points over a box inside the cell, over the whole cell without one; the box's extent.
Cube controlPoints(const SplineField& field, const Index3& cell, const Eigen::Vector3d* low,
                   const Eigen::Vector3d* high, Eigen::Vector3d& extent) {
  Cube cube{};
  field.cellSamples(cell, cube.v);
  extent = Eigen::Vector3d::Ones();
  for (int axis = 0; axis < 3; ++axis) {
    cube.alongAxis(axis, [&field](const Row& r) { return bezier(r, field.kind()); });
    if (low == nullptr) continue;
    const double from = std::clamp((*low)[axis] - cell[static_cast<std::size_t>(axis)], 0.0, 1.0);
    const double to = std::clamp((*high)[axis] - cell[static_cast<std::size_t>(axis)], 0.0, 1.0);
    extent[axis] = std::max(to - from, 1e-3);
    cube.alongAxis(axis, [&](const Row& r) { return restricted(r, from, from + extent[axis]); });
  }
  return cube;
}

// The derivative of a Bezier cubic, raised to degree 3 again.
Row derivative(const Row& b) {
  const double d0 = 3.0 * (b[1] - b[0]), d1 = 3.0 * (b[2] - b[1]), d2 = 3.0 * (b[3] - b[2]);
  return {d0, (d0 + 2.0 * d1) / 3.0, (2.0 * d1 + d2) / 3.0, d2};
}

double boundOf(const SplineField& field, const Index3& cell, const Eigen::Vector3d* low,
               const Eigen::Vector3d* high) {
  Eigen::Vector3d extent;
  const Cube cube = controlPoints(field, cell, low, high, extent);
  const Eigen::Vector3d unit = extent.cwiseProduct(field.geometry().spacing);
  double sum = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double own = straight(cube, a) / (unit[a] * unit[a]);
    sum += own * own;
    for (int b = a + 1; b < 3; ++b) {
      const double both = mixed(cube, a, b) / (unit[a] * unit[b]);
      sum += 2.0 * both * both;
    }
  }
  return std::sqrt(sum);
}

}  // namespace

double hessianBound(const SplineField& field, const Index3& cell, const Eigen::Vector3d& low,
                    const Eigen::Vector3d& high) {
  return boundOf(field, cell, &low, &high);
}

std::array<double, 2> slopeBounds(const SplineField& field, const Index3& cell,
                                  const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                                  const Eigen::Vector3d& direction) {
  Eigen::Vector3d extent;
  const Cube cube = controlPoints(field, cell, &low, &high, extent);
  // d/dx = J^-T d/di with J = direction matrix times spacing.
  const Eigen::Vector3d weights =
      (field.geometry().physicalToIndexMatrix() * direction).cwiseQuotient(extent);
  std::array<double, 64> sum{};
  for (int axis = 0; axis < 3; ++axis) {
    Cube part = cube;
    part.alongAxis(axis, derivative);
    for (std::size_t i = 0; i < 64; ++i) sum[i] += weights[axis] * part.v[i];
  }
  const auto [least, most] = std::minmax_element(sum.begin(), sum.end());
  return {*least, *most};
}

double hessianBound(const SplineField& field, const Index3& cell) {
  return boundOf(field, cell, nullptr, nullptr);
}

}  // namespace angiomesh

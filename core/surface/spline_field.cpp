// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/spline_field.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

struct Weights {
  double value[4];
  double slope[4];
};

/// Weights of the samples -1, 0, 1, 2 at t in [0, 1), and their derivatives by t.
Weights bsplineWeights(double t) {
  const double s = 1.0 - t;
  return {{s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0},
          {-0.5 * s * s, 1.5 * t * t - 2.0 * t, -1.5 * s * s + 2.0 * s, 0.5 * t * t}};
}

Weights catmullRomWeights(double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return {{0.5 * (-t3 + 2.0 * t2 - t), 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
           0.5 * (-3.0 * t3 + 4.0 * t2 + t), 0.5 * (t3 - t2)},
          {0.5 * (-3.0 * t2 + 4.0 * t - 1.0), 0.5 * (9.0 * t2 - 10.0 * t),
           0.5 * (-9.0 * t2 + 8.0 * t + 1.0), 0.5 * (3.0 * t2 - 2.0 * t)}};
}

/// Samples to cubic B-spline coefficients along one line, in place: c[i-1] + 4 c[i] + c[i+1] = 6
/// f[i] with c[-1] = 2 c[0] - c[1] at either end, so that a linear field stays linear up to the
/// border.
void prefilterLine(std::vector<double>& line, std::vector<double>& ratio) {
  const std::size_t n = line.size();
  if (n < 3) return;
  ratio[0] = 0.0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    ratio[i] = 1.0 / (4.0 - ratio[i - 1]);
    line[i] = (6.0 * line[i] - line[i - 1]) * ratio[i];
  }
  for (std::size_t i = n - 2; i >= 1; --i) line[i] -= ratio[i] * line[i + 1];
}

void prefilterAxis(std::vector<float>& values, const Geometry& g, int axis) {
  const int n = g.size[axis];
  const int b = axis == 0 ? 1 : 0;
  const int c = axis == 2 ? 1 : 2;
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? g.offset(0, 1, 0) : g.offset(0, 0, 1);
  parallelFor(0, static_cast<std::size_t>(g.size[c]), 1, [&](std::size_t first, std::size_t last) {
    std::vector<double> line(static_cast<std::size_t>(n));
    std::vector<double> ratio(line.size());
    for (std::size_t q = first; q < last; ++q)
      for (int p = 0; p < g.size[b]; ++p) {
        Index3 at{0, 0, 0};
        at[b] = p;
        at[c] = static_cast<int>(q);
        float* start = values.data() + g.offset(at[0], at[1], at[2]);
        for (int i = 0; i < n; ++i)
          line[static_cast<std::size_t>(i)] = start[static_cast<std::size_t>(i) * stride];
        prefilterLine(line, ratio);
        for (int i = 0; i < n; ++i)
          start[static_cast<std::size_t>(i) * stride] =
              static_cast<float>(line[static_cast<std::size_t>(i)]);
      }
  });
}

/// Puts the weights of the samples beyond the border on those within, as linear extrapolation.
void foldBorder(double (&w)[4], bool before, bool after) {
  if (before) {
    w[1] += 2.0 * w[0];
    w[2] -= w[0];
    w[0] = 0.0;
  }
  if (after) {
    w[2] += 2.0 * w[3];
    w[1] -= w[3];
    w[3] = 0.0;
  }
}

}  // namespace

SplineField::SplineField(const Volume<float>& samples, SplineKind kind)
    : geometry_(samples.geometry),
      toIndexMatrix_(samples.geometry.physicalToIndexMatrix()),
      kind_(kind),
      coefficients_(samples.voxels) {
  if (kind_ == SplineKind::InterpolatingBspline)
    for (int axis = 0; axis < 3; ++axis) prefilterAxis(coefficients_, geometry_, axis);
}

SplineField::Jet SplineField::atIndex(const Eigen::Vector3d& index) const {
  int at[3][4];
  Weights w[3];
  for (int a = 0; a < 3; ++a) {
    const int n = geometry_.size[a];
    const double x = std::clamp(index[a], 0.0, static_cast<double>(n - 1));
    const int cell = std::min(static_cast<int>(x), std::max(n - 2, 0));
    w[a] = kind_ == SplineKind::CatmullRom ? catmullRomWeights(x - cell) : bsplineWeights(x - cell);
    foldBorder(w[a].value, cell == 0, cell + 2 >= n);
    foldBorder(w[a].slope, cell == 0, cell + 2 >= n);
    for (int s = 0; s < 4; ++s) at[a][s] = std::clamp(cell - 1 + s, 0, n - 1);
  }
  Jet jet{0.0, Eigen::Vector3d::Zero()};
  for (int k = 0; k < 4; ++k) {
    double value = 0.0;
    double dx = 0.0;
    double dy = 0.0;
    for (int j = 0; j < 4; ++j) {
      const float* row = coefficients_.data() + geometry_.offset(0, at[1][j], at[2][k]);
      double v = 0.0;
      double d = 0.0;
      for (int i = 0; i < 4; ++i) {
        const double c = row[at[0][i]];
        v += w[0].value[i] * c;
        d += w[0].slope[i] * c;
      }
      value += w[1].value[j] * v;
      dx += w[1].value[j] * d;
      dy += w[1].slope[j] * v;
    }
    jet.value += w[2].value[k] * value;
    jet.gradient[0] += w[2].value[k] * dx;
    jet.gradient[1] += w[2].value[k] * dy;
    jet.gradient[2] += w[2].slope[k] * value;
  }
  return jet;
}

SplineField::Jet SplineField::at(const Eigen::Vector3d& pointLps) const {
  Jet jet = atIndex(toIndexMatrix_ * (pointLps - geometry_.origin));
  jet.gradient = toIndexMatrix_.transpose() * jet.gradient;
  return jet;
}

bool SplineField::projectToZero(Eigen::Vector3d& pointLps, double reachVoxels) const {
  const double voxel = geometry_.voxelMm();
  const Eigen::Vector3d start = pointLps;
  for (int n = 0; n < 50; ++n) {
    const Jet jet = at(pointLps);
    const double slope = jet.gradient.norm();
    if (!(slope > 1e-12)) return false;
    const double distance = jet.value / slope;
    if (std::fabs(distance) < 1e-6 * voxel) return true;
    const double step = std::clamp(distance, -0.5 * voxel, 0.5 * voxel);
    pointLps -= step / slope * jet.gradient;
    if ((pointLps - start).norm() > reachVoxels * voxel) return false;
  }
  return false;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/field/spline_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"

namespace angiomesh {
namespace {

// GCC's vector type of two doubles: one SSE2 or NEON register, the same operations in the same
// order everywhere.
using Pair = double __attribute__((vector_size(16)));
using FloatPair = float __attribute__((vector_size(8)));

/// Four samples next to each other along x.
struct Row {
  Pair low;
  Pair high;
};

Row load(const float* from) {
  FloatPair low;
  FloatPair high;
  std::memcpy(&low, from, sizeof low);
  std::memcpy(&high, from + 2, sizeof high);
  return {__builtin_convertvector(low, Pair), __builtin_convertvector(high, Pair)};
}

Row operator*(const Pair& w, const Row& r) { return {w * r.low, w * r.high}; }

void add(Row& sum, const Pair& w, const Row& r) {
  sum.low += w * r.low;
  sum.high += w * r.high;
}

double dot(const Row& w, const Row& r) {
  const Pair sum = w.low * r.low + w.high * r.high;
  return sum[0] + sum[1];
}

/// Weights of the samples -1, 0, 1, 2 at t in [0, 1] in w[0], and their derivatives by t up to
/// `order` in w[1] and w[2]. T is a number or a pair of them.
template <int order, class T>
void bsplineWeights(const T& t, T (&w)[order + 1][4]) {
  const T s = 1.0 - t;
  const T t2 = t * t;
  const T s2 = s * s;
  w[0][0] = s2 * s * (1.0 / 6.0);
  w[0][1] = t2 * (0.5 * t - 1.0) + 2.0 / 3.0;
  w[0][2] = s2 * (0.5 * s - 1.0) + 2.0 / 3.0;
  w[0][3] = t2 * t * (1.0 / 6.0);
  if constexpr (order > 0) {
    w[1][0] = -0.5 * s2;
    w[1][1] = t * (1.5 * t - 2.0);
    w[1][2] = s * (2.0 - 1.5 * s);
    w[1][3] = 0.5 * t2;
  }
  if constexpr (order > 1) {
    w[2][0] = s;
    w[2][1] = 3.0 * t - 2.0;
    w[2][2] = 3.0 * s - 2.0;
    w[2][3] = t;
  }
}

template <int order, class T>
void catmullRomWeights(const T& t, T (&w)[order + 1][4]) {
  const T s = 1.0 - t;
  const T t2 = t * t;
  const T s2 = s * s;
  w[0][0] = -0.5 * t * s2;
  w[0][1] = t2 * (1.5 * t - 2.5) + 1.0;
  w[0][2] = s2 * (1.5 * s - 2.5) + 1.0;
  w[0][3] = -0.5 * t2 * s;
  if constexpr (order > 0) {
    w[1][0] = -0.5 * s * (1.0 - 3.0 * t);
    w[1][1] = t * (4.5 * t - 5.0);
    w[1][2] = s * (5.0 - 4.5 * s);
    w[1][3] = 0.5 * t * (3.0 * t - 2.0);
  }
  if constexpr (order > 1) {
    w[2][0] = 2.0 - 3.0 * t;
    w[2][1] = 9.0 * t - 5.0;
    w[2][2] = 4.0 - 9.0 * t;
    w[2][3] = 3.0 * t - 1.0;
  }
}

template <int order, class T>
void weights(SplineKind kind, const T& t, T (&w)[order + 1][4]) {
  if (kind == SplineKind::CatmullRom)
    catmullRomWeights<order>(t, w);
  else
    bsplineWeights<order>(t, w);
}

/// Lines of samples that are filtered side by side: their recursions hide each other's latency, and
/// along y and z memory is read in runs.
constexpr int lanes = 16;

/// Samples to cubic B-spline coefficients along `lanes` lines, in place: c[i-1] + 4 c[i] + c[i+1] =
/// 6 f[i] with c[-1] = 2 c[0] - c[1] at either end, so that a linear field stays linear up to the
/// border. `ratio` are the pivots of the elimination.
void prefilterLines(double* lines, const std::vector<double>& ratio, int n) {
  for (int i = 1; i + 1 < n; ++i) {
    double* row = lines + static_cast<std::ptrdiff_t>(i) * lanes;
    const double r = ratio[static_cast<std::size_t>(i)];
    for (int l = 0; l < lanes; l += 2) {
      Pair at;
      Pair before;
      std::memcpy(&at, row + l, sizeof at);
      std::memcpy(&before, row + l - lanes, sizeof before);
      at = (6.0 * at - before) * r;
      std::memcpy(row + l, &at, sizeof at);
    }
  }
  for (int i = n - 2; i >= 1; --i) {
    double* row = lines + static_cast<std::ptrdiff_t>(i) * lanes;
    const double r = ratio[static_cast<std::size_t>(i)];
    for (int l = 0; l < lanes; l += 2) {
      Pair at;
      Pair after;
      std::memcpy(&at, row + l, sizeof at);
      std::memcpy(&after, row + l + lanes, sizeof after);
      at -= r * after;
      std::memcpy(row + l, &at, sizeof at);
    }
  }
}

/// Filters along one axis of a box of n samples, `stride` apart; the lines are `lineStride` apart,
/// and `lineCount` of them stand side by side in each of `slabCount` slabs.
struct Axis {
  int n;
  std::size_t stride;
  std::size_t lineCount, lineStride;
  std::size_t slabCount, slabStride;
};

void prefilterAxis(float* values, const Axis& axis) {
  if (axis.n < 3) return;
  std::vector<double> ratio(static_cast<std::size_t>(axis.n), 0.0);
  for (std::size_t i = 1; i + 1 < ratio.size(); ++i) ratio[i] = 1.0 / (4.0 - ratio[i - 1]);
  parallelFor(0, axis.slabCount, 2, [&](std::size_t first, std::size_t last) {
    std::vector<double> lines(static_cast<std::size_t>(axis.n) * lanes, 0.0);
    for (std::size_t slab = first; slab < last; ++slab)
      for (std::size_t line = 0; line < axis.lineCount; line += lanes) {
        float* start = values + slab * axis.slabStride + line * axis.lineStride;
        const std::size_t count = std::min<std::size_t>(lanes, axis.lineCount - line);
        for (int i = 0; i < axis.n; ++i) {
          const float* from = start + static_cast<std::size_t>(i) * axis.stride;
          double* to = lines.data() + static_cast<std::size_t>(i) * lanes;
          for (std::size_t l = 0; l < count; ++l) to[l] = from[l * axis.lineStride];
        }
        prefilterLines(lines.data(), ratio, axis.n);
        for (int i = 0; i < axis.n; ++i) {
          const double* from = lines.data() + static_cast<std::size_t>(i) * lanes;
          float* to = start + static_cast<std::size_t>(i) * axis.stride;
          for (std::size_t l = 0; l < count; ++l)
            to[l * axis.lineStride] = static_cast<float>(from[l]);
        }
      }
  });
}

/// Layers of the padded box along an axis of n samples: one before, and one or, where there is one
/// sample only, two behind.
std::size_t padded(int n) { return static_cast<std::size_t>(std::max(n, 2)) + 2; }

}  // namespace

/// The first coefficient of a point's cell, and the weights there with their derivatives up to
/// `order`; along y and z each weight stands twice, ready for both halves of a register.
template <int order>
struct SplineField::Place {
  const float* corner;
  Row x[order + 1];
  Pair y[order + 1][4];
  Pair z[order + 1][4];
};

SplineField::SplineField(const Volume<float>& samples, SplineKind kind)
    : geometry_(samples.geometry),
      toIndexMatrix_(samples.geometry.physicalToIndexMatrix()),
      kind_(kind) {
  const Index3& n = geometry_.size;
  rowStride_ = padded(n[0]);
  layerStride_ = rowStride_ * padded(n[1]);
  // atVoxel() reads one sample beyond the three that it needs.
  coefficients_.resize(layerStride_ * padded(n[2]) + 1);
  float* inner = coefficients_.data() + layerStride_ + rowStride_ + 1;
  const auto nx = static_cast<std::size_t>(n[0]);
  const auto ny = static_cast<std::size_t>(n[1]);
  const auto nz = static_cast<std::size_t>(n[2]);
  parallelForEach(nz, 4, [&](std::size_t k) {
    for (std::size_t j = 0; j < ny; ++j)
      std::copy_n(samples.voxels.data() + nx * (j + ny * k), nx,
                  inner + j * rowStride_ + k * layerStride_);
  });
  if (kind_ == SplineKind::InterpolatingBspline) {
    prefilterAxis(inner, {n[0], 1, ny, rowStride_, nz, layerStride_});
    prefilterAxis(inner, {n[1], rowStride_, nx, 1, nz, layerStride_});
    prefilterAxis(inner, {n[2], layerStride_, nx, 1, ny, rowStride_});
  }
  extrapolate();
}

void SplineField::extrapolate() {
  const Index3& n = geometry_.size;
  const std::size_t stride[3] = {1, rowStride_, layerStride_};
  const std::size_t layers[3] = {padded(n[0]), padded(n[1]), padded(n[2])};
  // Axis by axis, so that the layers of one axis take part in those of the next.
  for (int a = 0; a < 3; ++a) {
    const int b = a == 0 ? 1 : 0;
    const int c = a == 2 ? 1 : 2;
    const auto last = static_cast<std::size_t>(n[a]);  // the padded place of the last sample
    for (std::size_t q = 0; q < layers[c]; ++q)
      for (std::size_t p = 0; p < layers[b]; ++p) {
        float* line = coefficients_.data() + p * stride[b] + q * stride[c];
        const auto at = [&](std::size_t i) -> float& { return line[i * stride[a]]; };
        if (last == 1) {
          at(0) = at(2) = at(3) = at(1);
        } else {
          at(0) = 2.0F * at(1) - at(2);
          at(last + 1) = 2.0F * at(last) - at(last - 1);
        }
      }
  }
}

template <int order>
void SplineField::place(const Eigen::Vector3d& index, Place<order>& p) const {
  std::size_t cell[3];
  double t[3];
  for (int a = 0; a < 3; ++a) {
    const int n = geometry_.size[a];
    const double x = std::clamp(index[a], 0.0, static_cast<double>(n - 1));
    const int c = std::min(static_cast<int>(x), std::max(n - 2, 0));
    cell[a] = static_cast<std::size_t>(c);
    t[a] = x - c;
  }
  p.corner = coefficients_.data() + cell[0] + cell[1] * rowStride_ + cell[2] * layerStride_;
  double alongX[order + 1][4];
  Pair alongYz[order + 1][4];
  weights<order>(kind_, t[0], alongX);
  weights<order>(kind_, Pair{t[1], t[2]}, alongYz);
  for (int d = 0; d <= order; ++d) {
    p.x[d].low = Pair{alongX[d][0], alongX[d][1]};
    p.x[d].high = Pair{alongX[d][2], alongX[d][3]};
    for (int s = 0; s < 4; ++s) {
      const Pair w = alongYz[d][s];
      p.y[d][s] = Pair{w[0], w[0]};
      p.z[d][s] = Pair{w[1], w[1]};
    }
  }
}

SplineField::Jet SplineField::atIndex(const Eigen::Vector3d& index) const {
  Place<1> p;
  place<1>(index, p);
  Row value{};
  Row dy{};
  Row dz{};
  for (std::size_t k = 0; k < 4; ++k) {
    const float* layer = p.corner + k * layerStride_;
    const Row first = load(layer);
    Row v = p.y[0][0] * first;
    Row d = p.y[1][0] * first;
    for (std::size_t j = 1; j < 4; ++j) {
      const Row row = load(layer + j * rowStride_);
      add(v, p.y[0][j], row);
      add(d, p.y[1][j], row);
    }
    add(value, p.z[0][k], v);
    add(dy, p.z[0][k], d);
    add(dz, p.z[1][k], v);
  }
  return {dot(p.x[0], value), {dot(p.x[1], value), dot(p.x[0], dy), dot(p.x[0], dz)}};
}

SplineField::Jet SplineField::at(const Eigen::Vector3d& pointLps) const {
  Jet jet = atIndex(toIndexMatrix_ * (pointLps - geometry_.origin));
  jet.gradient = toIndexMatrix_.transpose() * jet.gradient;
  return jet;
}

double SplineField::valueAt(const Eigen::Vector3d& pointLps) const {
  Place<0> p;
  place<0>(toIndexMatrix_ * (pointLps - geometry_.origin), p);
  Row value{};
  for (std::size_t k = 0; k < 4; ++k) {
    const float* layer = p.corner + k * layerStride_;
    Row v = p.y[0][0] * load(layer);
    for (std::size_t j = 1; j < 4; ++j) add(v, p.y[0][j], load(layer + j * rowStride_));
    add(value, p.z[0][k], v);
  }
  return dot(p.x[0], value);
}

SplineField::SecondJet SplineField::secondAt(const Eigen::Vector3d& pointLps) const {
  Place<2> p;
  place<2>(toIndexMatrix_ * (pointLps - geometry_.origin), p);
  Row value{};
  Row dy{};
  Row dz{};
  Row dyy{};
  Row dyz{};
  Row dzz{};
  for (std::size_t k = 0; k < 4; ++k) {
    const float* layer = p.corner + k * layerStride_;
    const Row first = load(layer);
    Row v = p.y[0][0] * first;
    Row d = p.y[1][0] * first;
    Row dd = p.y[2][0] * first;
    for (std::size_t j = 1; j < 4; ++j) {
      const Row row = load(layer + j * rowStride_);
      add(v, p.y[0][j], row);
      add(d, p.y[1][j], row);
      add(dd, p.y[2][j], row);
    }
    add(value, p.z[0][k], v);
    add(dy, p.z[0][k], d);
    add(dz, p.z[1][k], v);
    add(dyy, p.z[0][k], dd);
    add(dyz, p.z[1][k], d);
    add(dzz, p.z[2][k], v);
  }
  const double xy = dot(p.x[1], dy);
  const double xz = dot(p.x[1], dz);
  const double yz = dot(p.x[0], dyz);
  Eigen::Matrix3d hessian;
  hessian << dot(p.x[2], value), xy, xz, xy, dot(p.x[0], dyy), yz, xz, yz, dot(p.x[0], dzz);
  const Eigen::Vector3d gradient(dot(p.x[1], value), dot(p.x[0], dy), dot(p.x[0], dz));
  return {dot(p.x[0], value), toIndexMatrix_.transpose() * gradient,
          toIndexMatrix_.transpose() * hessian * toIndexMatrix_};
}

void SplineField::cellSamples(const Index3& cell, std::array<double, 64>& samples) const {
  const float* corner = coefficients_.data() + static_cast<std::size_t>(cell[0]) +
                        static_cast<std::size_t>(cell[1]) * rowStride_ +
                        static_cast<std::size_t>(cell[2]) * layerStride_;
  std::size_t n = 0;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i)
        samples[n++] = static_cast<double>(corner[i + j * rowStride_ + k * layerStride_]);
}

void SplineField::atVoxels(int first, int last, int j, int k, float* values) const {
  const float* at = coefficients_.data() + static_cast<std::size_t>(first) +
                    static_cast<std::size_t>(j) * rowStride_ +
                    static_cast<std::size_t>(k) * layerStride_;
  const auto count = static_cast<std::size_t>(last - first + 1);
  std::size_t done = 0;
  if (kind_ != SplineKind::CatmullRom) {
    constexpr double outer = 1.0 / 6.0;
    constexpr double middle = 2.0 / 3.0;
    // Four columns at a time give two values: each needs a column on either side.
    for (; done + 2 <= count; done += 2) {
      Row layers[3];
      for (std::size_t c = 0; c < 3; ++c) {
        const float* layer = at + done + c * layerStride_;
        const Row before = load(layer);
        const Row here = load(layer + rowStride_);
        const Row after = load(layer + 2 * rowStride_);
        layers[c].low = outer * (before.low + after.low) + middle * here.low;
        layers[c].high = outer * (before.high + after.high) + middle * here.high;
      }
      const Pair low = outer * (layers[0].low + layers[2].low) + middle * layers[1].low;
      const Pair high = outer * (layers[0].high + layers[2].high) + middle * layers[1].high;
      values[done] = static_cast<float>(outer * (low[0] + high[0]) + middle * low[1]);
      values[done + 1] = static_cast<float>(outer * (low[1] + high[1]) + middle * high[0]);
    }
  }
  for (; done < count; ++done)
    values[done] = static_cast<float>(atVoxel(first + static_cast<int>(done), j, k));
}

double SplineField::atVoxel(int i, int j, int k) const {
  const float* at = coefficients_.data() + static_cast<std::size_t>(i) +
                    static_cast<std::size_t>(j) * rowStride_ +
                    static_cast<std::size_t>(k) * layerStride_;
  if (kind_ == SplineKind::CatmullRom) return at[layerStride_ + rowStride_ + 1];
  constexpr double outer = 1.0 / 6.0;
  constexpr double middle = 2.0 / 3.0;
  Row layers[3];
  for (std::size_t c = 0; c < 3; ++c, at += layerStride_) {
    const Row before = load(at);
    const Row here = load(at + rowStride_);
    const Row after = load(at + 2 * rowStride_);
    layers[c].low = outer * (before.low + after.low) + middle * here.low;
    layers[c].high = outer * (before.high + after.high) + middle * here.high;
  }
  const Pair low = outer * (layers[0].low + layers[2].low) + middle * layers[1].low;
  const Pair high = outer * (layers[0].high + layers[2].high) + middle * layers[1].high;
  return outer * (low[0] + high[0]) + middle * low[1];
}

std::array<double, 2> SplineField::bounds(const Index3& first, const Index3& last) const {
  using Four = float __attribute__((vector_size(16)));
  Four low = Four{} + std::numeric_limits<float>::max();
  Four high = -low;
  // The samples first - 1 to last + 1 stand at first to last + 2 in the padded box; the last four
  // of a row overlap those before them.
  const auto count = static_cast<std::size_t>(last[0] - first[0]) + 3;
  for (auto k = static_cast<std::size_t>(first[2]); k < static_cast<std::size_t>(last[2]) + 3; ++k)
    for (auto j = static_cast<std::size_t>(first[1]); j < static_cast<std::size_t>(last[1]) + 3;
         ++j) {
      const float* row = coefficients_.data() + static_cast<std::size_t>(first[0]) +
                         j * rowStride_ + k * layerStride_;
      for (std::size_t i = 0; i < count; i += 4) {
        Four at;
        std::memcpy(&at, row + std::min(i, count - 4), sizeof at);
        low = at < low ? at : low;
        high = at > high ? at : high;
      }
    }
  double least = low[0];
  double greatest = high[0];
  for (int i = 1; i < 4; ++i) {
    least = std::min(least, static_cast<double>(low[i]));
    greatest = std::max(greatest, static_cast<double>(high[i]));
  }
  // The Catmull-Rom weights sum to 1, their magnitudes to at most (5/4)^3, so the negative ones to
  // at most 61/128.
  const double more = kind_ == SplineKind::CatmullRom ? 61.0 / 128.0 * (greatest - least) : 0.0;
  return {least - more, greatest + more};
}

bool SplineField::projectToZero(Eigen::Vector3d& pointLps, double reachVoxels) const {
  const double voxel = geometry_.voxelMm();
  const double reach = reachVoxels * voxel;
  const Eigen::Vector3d start = pointLps;
  for (int n = 0; n < 50; ++n) {
    const Jet jet = at(pointLps);
    const double slope = jet.gradient.norm();
    if (!(slope > 1e-12)) return false;
    const double distance = jet.value / slope;
    if (std::fabs(distance) < 1e-6 * voxel) return true;
    const double step = std::clamp(distance, -0.5 * voxel, 0.5 * voxel);
    pointLps -= step / slope * jet.gradient;
    if ((pointLps - start).squaredNorm() > reach * reach) return false;
    if (std::fabs(distance) < 3e-4 * voxel) return true;
  }
  return false;
}

double PrincipalCurvatures::maximal() const { return std::max(std::fabs(k1), std::fabs(k2)); }

PrincipalCurvatures principalCurvatures(const SplineField::SecondJet& jet) {
  const double slope = jet.gradient.norm();
  if (!(slope > 1e-12)) return {};
  const Eigen::Vector3d n = jet.gradient / slope;
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  const Eigen::Vector3d u = n.cross(Eigen::Vector3d::Unit(axis)).normalized();
  const Eigen::Vector3d v = n.cross(u);
  const Eigen::Vector3d hu = jet.hessian * u;
  const double uu = u.dot(hu);
  const double uv = v.dot(hu);
  const double vv = v.dot(jet.hessian * v);
  const double mean = 0.5 * (uu + vv) / slope;
  const double spread = std::sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv) / slope;
  if (!std::isfinite(mean) || !std::isfinite(spread)) return {};
  return {mean + spread, mean - spread};
}

}  // namespace angiomesh

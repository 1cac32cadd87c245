// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/row_kernels.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/simd.h"

namespace angiomesh {
namespace {

constexpr int kBlock = 32;  // samples that stay in registers while the taps go by

inline float larger(float a, float b) { return a > b ? a : b; }
inline float smaller(float a, float b) { return a < b ? a : b; }

/// e^-x for x >= 0, relative error below 1e-6: 2^n times a polynomial (Taylor, |f| <= 1/2 ln 2).
inline float exponentialDecay(float x) {
  const float y = smaller(x, 80.0F) * -1.4426950408889634F;
  const auto n = static_cast<std::int32_t>(y - 0.5F);
  const float f = (y - static_cast<float>(n)) * 0.6931471805599453F;
  const float p =
      1.0F +
      f * (1.0F + f * (0.5F + f * (0.16666667F +
                                   f * (0.041666667F + f * (0.0083333333F + f * 0.0013888889F)))));
  const std::int32_t bits = (n + 127) << 23;
  float scale = 0.0F;
  std::memcpy(&scale, &bits, sizeof scale);
  return p * scale;
}

/// Eigenvalues of kBlock symmetric matrices, sorted by magnitude.
inline void eigenvalues(const std::array<const float*, 6>& hessian, int first, float scale,
                        float* small, float* middle, float* large) {
  const float *hxx = hessian[0] + first, *hyy = hessian[1] + first, *hzz = hessian[2] + first;
  const float *hxy = hessian[3] + first, *hxz = hessian[4] + first, *hyz = hessian[5] + first;
  for (int i = 0; i < kBlock; ++i) {
    const float xx = scale * hxx[i], yy = scale * hyy[i], zz = scale * hzz[i];
    const float xy = scale * hxy[i], xz = scale * hxz[i], yz = scale * hyz[i];
    const float mean = (xx + yy + zz) * 0.33333333F;
    const float a = xx - mean, b = yy - mean, c = zz - mean;
    const float off = xy * xy + xz * xz + yz * yz;
    const float p2 = (a * a + b * b + c * c + 2.0F * off) * 0.16666667F;
    const float p = std::sqrt(p2);
    const float det = a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz);
    const float cube = p2 * p;
    const float r = smaller(std::fabs(det) * 0.5F / larger(cube, 1e-30F), 1.0F);
    // 4 c^3 - 3 c = r by Newton's method, c = cos(acos(r) / 3): the root of largest magnitude is
    // well separated from the other two.
    float cosine = 0.8660254F + 0.1339746F * r;
    for (int n = 0; n < 3; ++n)
      cosine -=
          (4.0F * cosine * cosine * cosine - 3.0F * cosine - r) / (12.0F * cosine * cosine - 3.0F);
    cosine = smaller(cosine, 1.0F);
    const float root = (det < 0.0F ? -2.0F : 2.0F) * cosine;
    const float spread = std::sqrt(larger(3.0F * (4.0F - root * root), 0.0F));
    const float e0 = mean + p * root;
    const float e1 = mean + p * 0.5F * (spread - root);
    const float e2 = mean - p * 0.5F * (spread + root);
    // Sorted by magnitude, |s0| <= |s1| <= |s2|.
    const float m0 = std::fabs(e0) > std::fabs(e1) ? e1 : e0;
    const float m1 = std::fabs(e0) > std::fabs(e1) ? e0 : e1;
    const float s2 = std::fabs(m1) > std::fabs(e2) ? m1 : e2;
    const float m2 = std::fabs(m1) > std::fabs(e2) ? e2 : m1;
    const float s0 = std::fabs(m0) > std::fabs(m2) ? m2 : m0;
    const float s1 = std::fabs(m0) > std::fabs(m2) ? m0 : m2;
    small[i] = s0;
    middle[i] = s1;
    large[i] = s2;
  }
}

// 1 - e^.. and so on of eq. 3.22 for all, whether they apply or not: a branch would cost more.
inline void measures(const float* small, const float* middle, const float* large,
                     const MeasureRow& measure, float* tube, float* dark) {
  const float plate = measure.plate, blob = measure.blob;
  const float beside = measure.negative ? 2.0F : 0.0F;
  for (int i = 0; i < kBlock; ++i) {
    const float s0 = small[i], s1 = middle[i], s2 = large[i];
    const float square2 = s2 * s2;
    const float ra2 = s1 * s1 / larger(square2, 1e-30F);
    const float rb2 = s0 * s0 / larger(std::fabs(s1 * s2), 1e-30F);
    const float norm2 = s0 * s0 + s1 * s1 + square2;
    tube[i] = (1.0F - exponentialDecay(ra2 * plate)) * exponentialDecay(rb2 * blob) *
              (1.0F - exponentialDecay(norm2 * 0.5F));
    dark[i] = exponentialDecay(square2 * beside) - 1.0F;
  }
}

}  // namespace

ANGIOMESH_SIMD
void sumRows(const float* centre, const float* const* low, const float* const* high,
             const float* weights, int radius, int width, float* __restrict to) {
  int x = 0;
  for (; x + kBlock <= width; x += kBlock) {
    float sum[kBlock];
    for (int i = 0; i < kBlock; ++i) sum[i] = weights[0] * centre[x + i];
    for (int m = 0; m < radius; ++m) {
      const float w = weights[m + 1];
      const float* __restrict a = low[m] + x;
      const float* __restrict b = high[m] + x;
      for (int i = 0; i < kBlock; ++i) sum[i] += w * (a[i] + b[i]);
    }
    for (int i = 0; i < kBlock; ++i) to[x + i] = sum[i];
  }
  for (; x < width; ++x) {
    float sum = weights[0] * centre[x];
    for (int m = 0; m < radius; ++m) sum += weights[m + 1] * (low[m][x] + high[m][x]);
    to[x] = sum;
  }
}

ANGIOMESH_SIMD
void firstDifference(const ShiftedRows& r, int width, float* __restrict to) {
  const float bt = r.beforeT, at = r.afterT;
  const float *b0 = r.before0, *b1 = r.before1, *a0 = r.after0, *a1 = r.after1;
  for (int x = 0; x < width; ++x)
    to[x] = 0.5F * ((a0[x] + at * (a1[x] - a0[x])) - (b0[x] + bt * (b1[x] - b0[x])));
}

ANGIOMESH_SIMD
void secondDifference(const ShiftedRows& r, const float* centre, int width, float* __restrict to) {
  const float bt = r.beforeT, at = r.afterT;
  const float *b0 = r.before0, *b1 = r.before1, *a0 = r.after0, *a1 = r.after1;
  for (int x = 0; x < width; ++x)
    to[x] = (a0[x] + at * (a1[x] - a0[x])) + (b0[x] + bt * (b1[x] - b0[x])) - 2.0F * centre[x];
}

ANGIOMESH_SIMD
void mergeMeasure(const std::array<const float*, 6>& hessian, const MeasureRow& measure, int width,
                  float* v) {
  float small[kBlock], middle[kBlock], large[kBlock], tube[kBlock], dark[kBlock], rest[6][kBlock];
  for (int first = 0; first < width; first += kBlock) {
    const int count = width - first < kBlock ? width - first : kBlock;
    if (count == kBlock) {
      eigenvalues(hessian, first, measure.scale, small, middle, large);
    } else {
      std::array<const float*, 6> last{};
      for (std::size_t c = 0; c < 6; ++c) {
        for (int i = 0; i < kBlock; ++i) rest[c][i] = i < count ? hessian[c][first + i] : 0.0F;
        last[c] = rest[c];
      }
      eigenvalues(last, 0, measure.scale, small, middle, large);
    }
    measures(small, middle, large, measure, tube, dark);
    for (int i = 0; i < count; ++i) {
      const float bright = middle[i] < 0.0F && large[i] < 0.0F ? tube[i] : 0.0F;
      const float here = large[i] > 0.0F ? dark[i] : bright;
      v[first + i] = std::fabs(here) > std::fabs(v[first + i]) ? here : v[first + i];
    }
  }
}

}  // namespace angiomesh

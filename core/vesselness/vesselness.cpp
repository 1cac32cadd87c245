// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/vesselness.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/vesselness/hessian_slices.h"
#include "core/vesselness/row_kernels.h"

namespace angiomesh {
namespace {

/// One root c in [sqrt(3)/2, 1] of 4 c^3 - 3 c = r, 0 <= r <= 1 (c = cos(acos(r) / 3)), by Newton's
/// method.
double cosineOfThird(double r) {
  double c = 0.8660254037844386 + 0.1339745962155614 * r;
  for (int n = 0; n < 4; ++n) c -= (4.0 * c * c * c - 3.0 * c - r) / (12.0 * c * c - 3.0);
  return std::min(c, 1.0);
}

/// Eq. 3.15 and 3.22 at one scale.
MeasureRow measureAt(const VesselnessParams& params, double sigmaMm, double sigmaMinMm, double c) {
  MeasureRow row;
  row.scale = static_cast<float>((params.polarity == Polarity::Bright ? 1.0 : -1.0) / c);
  // Log-spaced scales put one exactly on k.
  const double k = params.kMm.value_or(2.0 * sigmaMinMm) * (1.0 + 1e-6);
  row.negative = params.measure == VesselMeasure::Modified && sigmaMm <= k;
  row.plate = static_cast<float>(1.0 / (2.0 * params.alpha * params.alpha));
  row.blob = static_cast<float>(1.0 / (2.0 * params.beta * params.beta));
  return row;
}

/// Writes v at sigma over `out` where its magnitude is larger.
void mergeScale(const Volume<float>& image, double sigmaMm, const MeasureRow& measure,
                Volume<float>& out, const Progress& progress) {
  const Geometry& g = image.geometry;
  const std::size_t slice = g.offset(0, 0, 1);
  std::atomic<int> done{0};
  forEachHessianSlice(
      image, sigmaMm,
      [&](int k, const HessianSlice& h) {
        float* to = out.voxels.data() + static_cast<std::size_t>(k) * slice;
        mergeMeasure(h, measure, static_cast<int>(slice), to);
        progress.report(static_cast<double>(++done) / g.size[2]);
      },
      progress);
}

double sigmaMin(const VesselnessParams& params, const Geometry& g) {
  return params.sigmaMinMm.value_or(g.voxelMm());
}

}  // namespace

std::array<double, 3> symmetricEigenvalues(const std::array<double, 6>& h) {
  const double mean = (h[0] + h[1] + h[2]) / 3.0;
  const double a = h[0] - mean;
  const double b = h[1] - mean;
  const double c = h[2] - mean;
  const double off = h[3] * h[3] + h[4] * h[4] + h[5] * h[5];
  const double p2 = (a * a + b * b + c * c + 2.0 * off) / 6.0;
  std::array<double, 3> l{mean, mean, mean};
  if (p2 > 0.0) {
    const double p = std::sqrt(p2);
    const double determinant = a * (b * c - h[5] * h[5]) - h[3] * (h[3] * c - h[5] * h[4]) +
                               h[4] * (h[3] * h[5] - b * h[4]);
    const double r = std::clamp(determinant / (2.0 * p2 * p), -1.0, 1.0);
    // beta^3 - 3 beta = 2 r: the root of largest magnitude is well separated from the other two.
    const double root = 2.0 * cosineOfThird(std::fabs(r)) * (r < 0.0 ? -1.0 : 1.0);
    const double spread = std::sqrt(std::max(0.0, 3.0 * (4.0 - root * root)));
    l = {mean + p * root, mean + p * 0.5 * (-root + spread), mean + p * 0.5 * (-root - spread)};
  }
  const auto order = [&l](int i, int j) {
    if (std::fabs(l[i]) > std::fabs(l[j])) std::swap(l[i], l[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return l;
}

std::vector<double> scalesMm(const VesselnessParams& params, const Geometry& geometry) {
  const double low = sigmaMin(params, geometry);
  const double high = params.sigmaMaxMm.value_or(6.0 * geometry.voxelMm());
  if (high < low)
    throw InputError("the largest scale (" + std::to_string(high) + " mm) is below the smallest (" +
                         std::to_string(low) + " mm)",
                     "vesselness.sigmaMaxMm", "make it at least vesselness.sigmaMinMm");
  int count = 1;
  const double ratio = portableLog(high / low);
  if (params.scales) {
    count = *params.scales;
  } else if (ratio > 1e-9) {
    const double log15 = portableLog(1.5);
    const double difference = (high - low) / geometry.voxelMm();
    // The small amount keeps a ratio of exactly 1.5^n at n.
    count = params.scaleRule == ScaleRule::Ratio
                ? static_cast<int>(std::ceil(ratio / log15 - 1e-9)) + 1
                : std::max(2, static_cast<int>(std::ceil(portableLog(difference) / log15 - 1e-9)));
  }
  std::vector<double> scales;
  for (int i = 0; i < count; ++i)
    scales.push_back(i == 0
                         ? low
                         : portableExp(portableLog(low) +
                                       i * (portableLog(high) - portableLog(low)) / (count - 1)));
  return scales;
}

double contrastC(const VesselnessParams& params, const Volume<float>& image) {
  if (params.c) return *params.c;
  double contrast = 0.0;
  if (params.contrast == ContrastRule::Robust) {
    const bool bright = params.polarity == Polarity::Bright;
    const std::vector<double> p = percentiles(image, {bright ? 0.999 : 0.001, 0.5});
    contrast = std::fabs(p[0] - p[1]);
  }
  if (contrast <= 0.0) {
    const auto range = valueRange(image);
    contrast = static_cast<double>(range[1]) - static_cast<double>(range[0]);
  }
  return params.cFraction * contrast;
}

Volume<float> vesselnessAtScale(const Volume<float>& image, double sigmaMm,
                                const VesselnessParams& params, double c,
                                const Progress& progress) {
  Volume<float> out(image.geometry);
  mergeScale(image, sigmaMm, measureAt(params, sigmaMm, sigmaMin(params, image.geometry), c), out,
             progress);
  return out;
}

Volume<float> vesselness(const Volume<float>& image, const VesselnessParams& params,
                         const Progress& progress) {
  const std::vector<double> scales = scalesMm(params, image.geometry);
  const double c = contrastC(params, image);
  Volume<float> out(image.geometry);
  const auto count = static_cast<double>(scales.size());
  for (std::size_t i = 0; i < scales.size(); ++i)
    mergeScale(image, scales[i], measureAt(params, scales[i], scales[0], c), out,
               progress.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
  return out;
}

}  // namespace angiomesh

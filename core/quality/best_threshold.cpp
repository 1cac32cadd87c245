// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/best_threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/base/exact_math.h"
#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr std::size_t kSteps = 4096;

/// The best threshold of an image as it is.
BestThreshold bestOf(const BigVector<float>& values, const Volume<std::uint8_t>& truth) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double first = static_cast<double>(*low);
  const double range = static_cast<double>(*high) - first;
  std::array<std::vector<std::size_t>, 2> histogram;
  for (auto& h : histogram) h.assign(kSteps, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double step = range > 0.0 ? (static_cast<double>(values[i]) - first) / range : 0.0;
    const auto bin = std::min(static_cast<std::size_t>(step * kSteps), kSteps - 1);
    ++histogram[truth.voxels[i] != 0 ? 1 : 0][bin];
  }
  double vessel = 0.0;
  for (const std::size_t n : histogram[1]) vessel += static_cast<double>(n);
  BestThreshold best;
  double hit = 0.0;
  double miss = 0.0;
  for (std::size_t bin = kSteps; bin-- > 0;) {
    hit += static_cast<double>(histogram[1][bin]);
    miss += static_cast<double>(histogram[0][bin]);
    const double sum = hit + miss + vessel;
    const double overlap = sum > 0.0 ? 200.0 * hit / sum : 0.0;
    if (overlap > best.overlap) {
      best.overlap = overlap;
      best.threshold = first + range * static_cast<double>(bin) / kSteps;
    }
  }
  return best;
}

/// A sampled Gaussian out to four sigma along each axis, values clamped at the border: what image
/// tools have, and at these widths a little better than the discrete one of Lindeberg.
BigVector<float> gaussian(const Volume<float>& image, double sigma) {
  const int reach = static_cast<int>(std::floor(4.0 * sigma + 0.5));
  std::vector<double> weight(static_cast<std::size_t>(reach) + 1);
  double sum = 0.0;
  for (int m = -reach; m <= reach; ++m)
    sum += weight[static_cast<std::size_t>(std::abs(m))] =
        portableExp(-0.5 * m * m / (sigma * sigma));
  BigVector<float> from = image.voxels;
  BigVector<float> to(from.size());
  std::size_t stride = 1;
  for (const int size : image.geometry.size) {
    const auto lines = from.size() / stride;  // of `stride` voxels, `size` of them in a row
    parallelForEach(lines, 1 + 65536 / stride, [&](std::size_t line) {
      const int at = static_cast<int>(line % static_cast<std::size_t>(size));
      float* out = to.data() + line * stride;
      std::fill_n(out, stride, 0.0F);
      for (int m = -reach; m <= reach; ++m) {
        const std::ptrdiff_t step = std::clamp(at + m, 0, size - 1) - at;
        const float* in = from.data() + (static_cast<std::ptrdiff_t>(line) + step) *
                                            static_cast<std::ptrdiff_t>(stride);
        const auto w = static_cast<float>(weight[static_cast<std::size_t>(std::abs(m))] / sum);
        for (std::size_t i = 0; i < stride; ++i) out[i] += w * in[i];
      }
    });
    std::swap(from, to);
    stride *= static_cast<std::size_t>(size);
  }
  return from;
}

}  // namespace

BestThreshold bestThreshold(const Volume<float>& image, const Volume<std::uint8_t>& truth) {
  BestThreshold best = bestOf(image.voxels, truth);
  for (int tenths = 3; tenths <= 10; ++tenths) {
    const double sigma = 0.1 * tenths;
    BestThreshold one = bestOf(gaussian(image, sigma), truth);
    one.sigmaVoxels = sigma;
    if (one.overlap > best.overlap) best = one;
  }
  return best;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/gauss_kernel.h"

#include <cmath>
#include <cstddef>

namespace angiomesh {

std::vector<float> discreteGaussian(double variance, double maximumError, int maximumRadius) {
  if (variance < 1e-6) return {1.0F};
  // Miller's downward recurrence I_{n-1} = I_{n+1} + (2 n / t) I_n, scaled by I_0 + 2 sum I_n =
  // e^t.
  const int top = maximumRadius + 20 + static_cast<int>(6.0 * std::sqrt(variance));
  std::vector<double> bessel(static_cast<std::size_t>(top) + 2, 0.0);
  bessel[static_cast<std::size_t>(top)] = 1e-300;
  for (int n = top; n >= 1; --n) {
    const auto i = static_cast<std::size_t>(n);
    bessel[i - 1] = bessel[i + 1] + 2.0 * n / variance * bessel[i];
    if (bessel[i - 1] > 1e200)
      for (double& value : bessel) value *= 1e-250;
  }
  double all = bessel[0];
  for (std::size_t n = 1; n < bessel.size(); ++n) all += 2.0 * bessel[n];

  double sum = bessel[0] / all;
  std::size_t radius = 0;
  while (sum < 1.0 - maximumError && radius < static_cast<std::size_t>(maximumRadius))
    sum += 2.0 * bessel[++radius] / all;
  std::vector<float> kernel;
  for (std::size_t n = 0; n <= radius; ++n)
    kernel.push_back(static_cast<float>(bessel[n] / all / sum));
  return kernel;
}

}  // namespace angiomesh

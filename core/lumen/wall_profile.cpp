// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/wall_profile.h"

#include <algorithm>
#include <cmath>

#include "core/base/exact_math.h"
#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr double kLeastSpread = 0.2, kLargestSpread = 1.6;
constexpr std::size_t kFewestCells = 200, kMostCells = 50000;
constexpr std::size_t kGrain = 1024;

/// The smallest value of a function with one minimum (golden section).
template <class Cost>
double minimiser(double low, double high, const Cost& cost) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double atA = cost(a), atB = cost(b);
  while (high - low > 1e-3) {
    if (atA < atB) {
      high = b;
      b = a;
      atB = atA;
      a = high - golden * (high - low);
      atA = cost(a);
    } else {
      low = a;
      a = b;
      atA = atB;
      b = low + golden * (high - low);
      atB = cost(b);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

double wallUncertainty(double noiseToContrast) { return 1.4584536 * noiseToContrast; }

double WallProfile::argument(double distance, const WallBend& bend) const {
  const double half = 0.5 * static_cast<double>(bend.mean);
  const double root = std::sqrt(std::max(half * half - static_cast<double>(bend.gauss), 0.0));
  double sum = 0.0;
  for (const double k : {half + root, half - root}) sum += k / std::max(1.0 + k * distance, 0.3);
  return distance / spread + 0.5 * spread * sum;
}

// The normal distribution: Abramowitz and Stegun 7.1.26, error below 1e-7.
double WallProfile::share(double argument) {
  const double z = std::fabs(argument) * 0.7071067811865476;
  const double t = 1.0 / (1.0 + 0.3275911 * z);
  const double series =
      0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)));
  const double tail = 0.5 * t * series * portableExp(-z * z);
  return argument > 0.0 ? tail : 1.0 - tail;
}

double WallProfile::slope(double argument) const {
  return 0.3989422804014327 * portableExp(-0.5 * argument * argument) / spread;
}

double measureSpread(const WallCells& cells, const WallEvidence& evidence,
                     const std::vector<std::uint32_t>& number, const std::vector<float>& radius,
                     const std::vector<WallBend>& bends) {
  std::vector<std::uint32_t> chosen;
  for (const float least : {2.0F, 1.2F}) {
    if (chosen.size() >= kFewestCells) break;
    chosen.clear();
    for (std::uint32_t n = 0; n < cells.size(); ++n) {
      if (number[n] == kNoEvidence || std::fabs(cells[n].distance) > 2.0F || radius[n] < least)
        continue;
      if (evidence.lumen[number[n]] > evidence.around[number[n]]) chosen.push_back(n);
    }
  }
  if (chosen.size() < kFewestCells) return 0.0;
  const std::size_t stride = 1 + (chosen.size() - 1) / kMostCells;
  const std::size_t count = (chosen.size() - 1) / stride + 1;
  const auto cost = [&](double spread) {
    const WallProfile profile{spread};
    std::vector<double> part((count + kGrain - 1) / kGrain, 0.0);
    parallelFor(0, count, kGrain, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t n = chosen[i * stride], e = number[n];
        const double seen = static_cast<double>((evidence.value[e] - evidence.around[e]) /
                                                (evidence.lumen[e] - evidence.around[e]));
        const double x = profile.argument(static_cast<double>(cells[n].distance), bends[n]);
        const double off = std::clamp(seen - WallProfile::share(x), -1.0, 1.0);
        part[first / kGrain] += off * off;
      }
    });
    double sum = 0.0;
    for (const double p : part) sum += p;
    return sum;
  };
  return minimiser(kLeastSpread, kLargestSpread, cost);
}

}  // namespace angiomesh

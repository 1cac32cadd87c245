// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/exact_math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace angiomesh {
namespace {

constexpr double kLn2High = 6.93147180369123816490e-01;  // ln 2 in two parts (Cody and Waite 1980)
constexpr double kLn2Low = 1.90821492927058770002e-10;
constexpr double kTwoPi = 6.283185307179586476925;

double scaleByPowerOfTwo(double x, int exponent) {
  const auto bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  return x * std::bit_cast<double>(bits);
}

/// sin and cos of t, |t| <= pi/4, by their Taylor series.
double sineSeries(double t) {
  const double z = t * t;
  double sum = 1.0;
  for (int n = 8; n >= 1; --n) sum = 1.0 - z / (2.0 * n * (2.0 * n + 1.0)) * sum;
  return t * sum;
}

double cosineSeries(double t) {
  const double z = t * t;
  double sum = 1.0;
  for (int n = 9; n >= 1; --n) sum = 1.0 - z / ((2.0 * n - 1.0) * 2.0 * n) * sum;
  return sum;
}

}  // namespace

double portableExp(double x) {
  if (x < -708.0) return 0.0;
  if (x > 709.0) return std::numeric_limits<double>::infinity();
  const double k = std::floor(x * 1.44269504088896340736 + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  // Taylor series to r^13: |r| <= 0.347, remainder below 1e-17.
  constexpr double inverse[] = {1.0 / 13, 1.0 / 12, 1.0 / 11, 1.0 / 10, 1.0 / 9, 1.0 / 8, 1.0 / 7,
                                1.0 / 6,  1.0 / 5,  1.0 / 4,  1.0 / 3,  1.0 / 2, 1.0};
  double sum = 1.0;
  for (const double f : inverse) sum = 1.0 + r * f * sum;
  const int exponent = static_cast<int>(k);
  if (exponent > 1023) return scaleByPowerOfTwo(sum * 2.0, exponent - 1);
  return scaleByPowerOfTwo(sum, exponent);
}

double portableLog(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1023;
  double m = std::bit_cast<double>((bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);  // |s| <= 0.172; log m = 2 atanh s
  const double z = s * s;
  double sum = 0.0;
  for (int n = 21; n >= 1; n -= 2) sum = sum * z + 1.0 / n;
  return exponent * kLn2High + (2.0 * s * sum + exponent * kLn2Low);
}

double portableCubeRoot(double x) {
  const double root = portableExp(portableLog(x) / 3.0);
  return root - (root * root * root - x) / (3.0 * root * root);
}

double portableCosTurns(double x) {
  const double turns = std::fabs(x - std::floor(x + 0.5));  // 0 .. 1/2
  if (turns > 0.375) return -cosineSeries((0.5 - turns) * kTwoPi);
  if (turns > 0.125) return sineSeries((0.25 - turns) * kTwoPi);
  return cosineSeries(turns * kTwoPi);
}

double portableSinTurns(double x) { return portableCosTurns(x - 0.25); }

}  // namespace angiomesh

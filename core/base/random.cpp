// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/random.h"

#include <cmath>

#include "core/base/exact_math.h"

namespace angiomesh {
namespace {

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t randomBits(std::uint64_t seed, std::uint64_t counter) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
  return mix(mix(seed + golden) + golden * (counter + 1));
}

double randomUniform(std::uint64_t seed, std::uint64_t counter) {
  return static_cast<double>(randomBits(seed, counter) >> 11) * 0x1p-53;
}

double randomNormal(std::uint64_t seed, std::uint64_t counter) {
  const double u = 1.0 - randomUniform(seed, 2 * counter);  // (0, 1]
  const double v = randomUniform(seed, 2 * counter + 1);
  return std::sqrt(-2.0 * portableLog(u)) * portableCosTurns(v);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "io/voxel_convert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/base/simd.h"

namespace angiomesh {
namespace {

constexpr std::size_t kBlock = 1024;  // voxels that stay in the first cache

/// Floats in their order as whole numbers, NaN beyond the infinities: unlike those of floats, their
/// minimum and maximum may be taken in any order, and so by a vector at a time.
inline std::int32_t keyOf(float value) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return bits ^ ((bits >> 31) & 0x7fffffff);
}
inline float valueOf(std::int32_t key) {
  return std::bit_cast<float>(key ^ ((key >> 31) & 0x7fffffff));
}

ANGIOMESH_SIMD
void keyRange(const float* values, std::size_t count, std::int32_t* least, std::int32_t* greatest) {
  std::int32_t low = std::numeric_limits<std::int32_t>::max(), high = -low - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t key = keyOf(values[i]);
    low = key < low ? key : low;
    high = key > high ? key : high;
  }
  *least = low;
  *greatest = high;
}

/// The facts of `count` floats that begin at voxel `first`.
ValueFacts factsOf(const float* values, std::size_t count, std::size_t first) {
  std::int32_t least = 0, greatest = 0;
  keyRange(values, count, &least, &greatest);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  ValueFacts facts;
  if (least > keyOf(-kInfinity) && greatest < keyOf(kInfinity)) {
    facts.least = valueOf(least);
    facts.greatest = valueOf(greatest);
    return facts;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(values[i])) {
      facts.firstNotFinite = first + i;
      break;
    }
  return facts;
}

template <class T>
constexpr bool kAlwaysExact = sizeof(T) < 4 || std::is_same_v<T, float>;

/// Whether `single` holds `value` exactly. The long double holds any 64 bits.
template <class T>
bool holds(float single, T value) {
  if constexpr (std::is_integral_v<T> && sizeof(T) == 8)
    return static_cast<long double>(single) == static_cast<long double>(value);
  else
    return static_cast<double>(single) == static_cast<double>(value) || value != value;
}

template <class T>
RunFacts convert(const VoxelData& data, std::span<const std::byte> run, std::size_t first,
                 float* out) {
  const std::size_t count = run.size() / sizeof(T);
  RunFacts facts;
  std::array<T, kBlock> block;
  for (std::size_t at = 0; at < count; at += kBlock) {
    const std::size_t n = std::min(kBlock, count - at);
    std::memcpy(block.data(), run.data() + at * sizeof(T), n * sizeof(T));
    float* const to = out + at;
    if (data.rescaled())
      for (std::size_t i = 0; i < n; ++i)
        to[i] = static_cast<float>(static_cast<double>(block[i]) * data.slope + data.intercept);
    else
      for (std::size_t i = 0; i < n; ++i) to[i] = static_cast<float>(block[i]);
    facts.values.add(factsOf(to, n, first + at));
    if constexpr (!kAlwaysExact<T>)
      for (std::size_t i = 0; i < n && !facts.rounded && !data.rescaled(); ++i)
        facts.rounded = !holds(to[i], block[i]);
  }
  return facts;
}

}  // namespace

RunFacts floatsOf(const VoxelData& data, std::span<const std::byte> run, std::size_t first,
                  float* out) {
  return withVoxelType(data.type,
                       [&](auto zero) { return convert<decltype(zero)>(data, run, first, out); });
}

bool maskOf(const VoxelData& data, std::span<const std::byte> run, std::uint8_t* out) {
  return withVoxelType(data.type, [&](auto zero) {
    using T = decltype(zero);
    bool numbers = true;
    for (std::size_t i = 0; i < run.size() / sizeof(T); ++i) {
      T stored;
      std::memcpy(&stored, run.data() + i * sizeof(T), sizeof(T));
      double value = static_cast<double>(stored);
      if (data.rescaled()) value = value * data.slope + data.intercept;
      if (std::isnan(value)) numbers = false;
      out[i] = value != 0.0 ? 1 : 0;
    }
    return numbers;
  });
}

}  // namespace angiomesh

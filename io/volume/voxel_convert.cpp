// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/voxel_convert.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace angiomesh {
namespace {

constexpr std::size_t kBlock = 1024;  // voxels that stay in the first cache

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
    facts.values.add(valueFacts(to, n, first + at));
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

void maskOf(const VoxelData& data, std::span<const std::byte> run, std::uint8_t* out) {
  withVoxelType(data.type, [&](auto zero) {
    using T = decltype(zero);
    for (std::size_t i = 0; i < run.size() / sizeof(T); ++i) {
      T stored;
      std::memcpy(&stored, run.data() + i * sizeof(T), sizeof(T));
      out[i] = stored != T{0} ? 1 : 0;
    }
  });
}

}  // namespace angiomesh

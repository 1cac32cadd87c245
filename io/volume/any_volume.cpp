// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/any_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace angiomesh {
namespace {

template <class To, class From>
bool holds(const Volume<From>& volume) {
  return std::all_of(volume.voxels.begin(), volume.voxels.end(), [](From value) {
    return value >= static_cast<From>(std::numeric_limits<To>::min()) &&
           value <= static_cast<From>(std::numeric_limits<To>::max()) &&
           value == std::floor(value) && !(value == From{0} && std::signbit(value));
  });
}

template <class To, class From>
Volume<To> converted(const Volume<From>& volume) {
  Volume<To> out(volume.geometry);
  std::transform(volume.voxels.begin(), volume.voxels.end(), out.voxels.begin(),
                 [](From value) { return static_cast<To>(value); });
  return out;
}

}  // namespace

std::string voxelTypeName(VoxelType type) {
  return withVoxelType(type, [](auto zero) -> std::string {
    using T = decltype(zero);
    const char* const kind = std::is_floating_point_v<T> ? "float"
                             : std::is_signed_v<T>       ? "int"
                                                         : "uint";
    return kind + std::to_string(8 * sizeof(T));
  });
}

std::size_t voxelTypeBytes(VoxelType type) {
  return withVoxelType(type, [](auto zero) { return sizeof(zero); });
}

const Geometry& geometryOf(const AnyVolume& volume) {
  return std::visit([](const auto& v) -> const Geometry& { return v.geometry; }, volume);
}

AnyVolume inNarrowestType(Volume<float> volume) {
  if (holds<std::int16_t>(volume)) return converted<std::int16_t>(volume);
  if (holds<std::uint16_t>(volume)) return converted<std::uint16_t>(volume);
  return volume;
}

AnyVolume inNarrowestType(Volume<double> volume) {
  if (holds<std::int16_t>(volume)) return converted<std::int16_t>(volume);
  if (holds<std::uint16_t>(volume)) return converted<std::uint16_t>(volume);
  // NaN stays NaN in float32 as well.
  const bool single = std::all_of(volume.voxels.begin(), volume.voxels.end(), [](double value) {
    return std::isnan(value) || static_cast<double>(static_cast<float>(value)) == value;
  });
  if (single) return converted<float>(volume);
  return volume;
}

void checkUsable(const AnyVolume& volume, const std::string& where) {
  std::visit(
      [&](const auto& v) {
        using T = std::decay_t<decltype(v.voxels.front())>;
        ValueFacts facts;
        if constexpr (std::is_floating_point_v<T>) {
          const auto bad = std::find_if(v.voxels.begin(), v.voxels.end(),
                                        [](T value) { return !std::isfinite(value); });
          if (bad != v.voxels.end())
            facts.firstNotFinite = static_cast<std::size_t>(bad - v.voxels.begin());
        }
        const bool constant = std::all_of(v.voxels.begin(), v.voxels.end(),
                                          [&](T value) { return value == v.voxels.front(); });
        facts.least = 0.0F;
        facts.greatest = constant ? 0.0F : 1.0F;
        checkUsable(v.geometry, facts, where);
      },
      volume);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "core/image/volume.h"

namespace angiomesh {

/// A volume in the type that its file has.
using AnyVolume =
    std::variant<Volume<std::int8_t>, Volume<std::uint8_t>, Volume<std::int16_t>,
                 Volume<std::uint16_t>, Volume<std::int32_t>, Volume<std::uint32_t>,
                 Volume<std::int64_t>, Volume<std::uint64_t>, Volume<float>, Volume<double>>;

/// In the order of AnyVolume's alternatives.
enum class VoxelType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

/// "int16", "float32" ...
std::string voxelTypeName(VoxelType type);
std::size_t voxelTypeBytes(VoxelType type);

inline VoxelType voxelTypeOf(const AnyVolume& volume) {
  return static_cast<VoxelType>(volume.index());
}
const Geometry& geometryOf(const AnyVolume& volume);

/// call(T()) for the type that `type` stands for.
template <class Function>
decltype(auto) withVoxelType(VoxelType type, const Function& call) {
  switch (type) {
    case VoxelType::Int8:
      return call(std::int8_t{});
    case VoxelType::UInt8:
      return call(std::uint8_t{});
    case VoxelType::Int16:
      return call(std::int16_t{});
    case VoxelType::UInt16:
      return call(std::uint16_t{});
    case VoxelType::Int32:
      return call(std::int32_t{});
    case VoxelType::UInt32:
      return call(std::uint32_t{});
    case VoxelType::Int64:
      return call(std::int64_t{});
    case VoxelType::UInt64:
      return call(std::uint64_t{});
    case VoxelType::Float32:
      return call(float{});
    case VoxelType::Float64:
      break;
  }
  return call(double{});
}

/// The values in the narrowest of int16, uint16 and float32 that holds all of them exactly, or in
/// float64.
AnyVolume inNarrowestType(Volume<float> volume);
AnyVolume inNarrowestType(Volume<double> volume);

/// As checkUsable() of a float volume, in the precision of the type.
void checkUsable(const AnyVolume& volume, const std::string& where);

}  // namespace angiomesh

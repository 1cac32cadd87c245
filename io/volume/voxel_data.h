// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/volume/any_volume.h"

namespace angiomesh {

/// A run of bytes in a file.
struct VoxelPiece {
  std::filesystem::path file;
  std::uintmax_t start = 0;
  std::uintmax_t bytes = 0;
};

/// How voxels are written that are no bytes: 12 0 -3 or 0c00fd.
enum class VoxelText { None, Numbers, Hexadecimal };

/// Where the voxels of an image lie and how.
struct VoxelData {
  VoxelType type = VoxelType::UInt8;
  bool swapBytes = false;
  bool deflated = false;             ///< zlib or gzip, in one piece
  VoxelText text = VoxelText::None;  ///< in one piece
  std::uintmax_t skipInflated = 0;   ///< bytes before the voxels, once inflated
  std::vector<VoxelPiece> pieces;    ///< in order
  std::uintmax_t voxels = 0;         ///< of one volume
  std::uintmax_t values = 1;         ///< per voxel: components, or points in time
  bool interleaved = false;          ///< the values of a voxel stand together
  double slope = 1.0, intercept = 0.0;

  [[nodiscard]] std::uintmax_t bytes() const { return voxels * values * voxelTypeBytes(type); }
  [[nodiscard]] bool rescaled() const { return slope != 1.0 || intercept != 0.0; }
};

inline constexpr std::uintmax_t kMostCounted = std::uintmax_t{1} << 22;

/// Calls take(first, bytes) for runs of voxels, in the byte order of this machine, each voxel once:
/// `first` is the number of the first voxel. Of several values per voxel those of number `value`.
/// Runs of one size begin at its multiples and come in any order and from several threads at once
/// where the data are not deflated. The check sum of deflated data is checked. Returns how many
/// values more there are than `data` says, as far as only reading shows it: of deflated data, where
/// it stops at some kMostCounted bytes, and of text.
/// @throws IoError (unreadable, truncated, damaged), InputError (text that is no number), Cancelled
std::uintmax_t readVoxels(
    const VoxelData& data, std::uintmax_t value,
    const std::function<void(std::size_t first, std::span<const std::byte>)>& take,
    const Progress& progress);

/// "the file is truncated (... of ... bytes of voxels)".
[[noreturn]] void throwTruncated(const std::filesystem::path& path, std::uintmax_t expected,
                                 std::uintmax_t found);

}  // namespace angiomesh

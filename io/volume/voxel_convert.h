// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "core/image/volume.h"
#include "io/volume/voxel_data.h"

namespace angiomesh {

/// What is seen of a run of voxels on the way.
struct RunFacts {
  ValueFacts values;
  bool rounded = false;  ///< some value is not held exactly by a float
};

/// The voxels of a run as floats, slope * value + intercept where that says anything else, rounded
/// once. Takes this machine's byte order; `first` is the number of the first voxel.
RunFacts floatsOf(const VoxelData& data, std::span<const std::byte> run, std::size_t first,
                  float* out);

/// 1 where a voxel is not 0, whatever slope and intercept are.
void maskOf(const VoxelData& data, std::span<const std::byte> run, std::uint8_t* out);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/image/voxels.h"

namespace angiomesh {

/// The voxels of a 3 x 3 x 3 neighbourhood that belong to an object, bit n for number n of
/// kSteps27.
using VoxelBits = std::uint32_t;

/// The topological numbers of the middle voxel for a 26-connected object and its 6-connected
/// background (Bertrand and Malandain, Pattern Recognition Letters 15, 1994), whether it belongs to
/// the object or not. It is simple, that is, adding or removing it changes no topology, when both
/// are 1.
struct VoxelTopology {
  int object = 0;      ///< parts of the object that the voxel touches
  int background = 0;  ///< parts of the background that it shares a face with
  /// The parts of the object; those of the background that reach a face.
  std::array<VoxelBits, 8> objectParts{}, backgroundParts{};

  [[nodiscard]] bool simple() const { return object == 1 && background == 1; }
};

VoxelTopology voxelTopology(VoxelBits object);

}  // namespace angiomesh

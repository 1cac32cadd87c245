// SPDX-License-Identifier: BSD-3-Clause
#include "core/topology/voxel_topology.h"

#include <bit>

namespace angiomesh {
namespace {

constexpr VoxelBits kMiddle = VoxelBits{1} << kMiddle27;

struct Neighbours {
  std::array<VoxelBits, 27> all{};     ///< 26-neighbours within the cube, without the middle
  std::array<VoxelBits, 27> facing{};  ///< 6-neighbours within N18, without the middle
  VoxelBits faces = 0;                 ///< the middle's 6-neighbours
  VoxelBits near = 0;                  ///< its 18-neighbours
};

constexpr Neighbours makeNeighbours() {
  Neighbours n;
  const auto steps = [](std::size_t a, std::size_t b, std::size_t axis) {
    const int d = kSteps27[a][axis] - kSteps27[b][axis];
    return d < 0 ? -d : d;
  };
  for (std::size_t a = 0; a < 27; ++a) {
    const int off = steps(a, kMiddle27, 0) + steps(a, kMiddle27, 1) + steps(a, kMiddle27, 2);
    if (off == 1) n.faces |= VoxelBits{1} << a;
    if (off == 1 || off == 2) n.near |= VoxelBits{1} << a;
  }
  for (std::size_t a = 0; a < 27; ++a)
    for (std::size_t b = 0; b < 27; ++b) {
      const int x = steps(a, b, 0);
      const int y = steps(a, b, 1);
      const int z = steps(a, b, 2);
      if (a == b || b == kMiddle27 || x > 1 || y > 1 || z > 1) continue;
      n.all[a] |= VoxelBits{1} << b;
      if (x + y + z == 1 && (n.near >> b & 1) != 0) n.facing[a] |= VoxelBits{1} << b;
    }
  return n;
}

constexpr Neighbours kNeighbours = makeNeighbours();

/// The part of `set` that is connected to its voxel `start` (one bit).
VoxelBits partOf(VoxelBits set, VoxelBits start, const std::array<VoxelBits, 27>& neighbours) {
  VoxelBits part = start;
  VoxelBits fresh = start;
  while (fresh != 0) {
    const auto at = static_cast<std::size_t>(std::countr_zero(fresh));
    fresh &= fresh - 1;
    const VoxelBits next = neighbours[at] & set & ~part;
    part |= next;
    fresh |= next;
  }
  return part;
}

VoxelBits lowest(VoxelBits bits) { return bits & (~bits + 1); }

}  // namespace

VoxelTopology voxelTopology(VoxelBits object) {
  VoxelTopology topology;
  VoxelBits left = object & ~kMiddle;
  while (left != 0) {
    const VoxelBits part = partOf(left, lowest(left), kNeighbours.all);
    left &= ~part;
    topology.objectParts[static_cast<std::size_t>(topology.object++)] = part;
  }
  VoxelBits set = ~object & kNeighbours.near;
  while ((set & kNeighbours.faces) != 0) {
    const VoxelBits part = partOf(set, lowest(set & kNeighbours.faces), kNeighbours.facing);
    set &= ~part;
    topology.backgroundParts[static_cast<std::size_t>(topology.background++)] = part;
  }
  return topology;
}

}  // namespace angiomesh

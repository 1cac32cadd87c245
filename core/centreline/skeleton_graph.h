// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/centreline/centre_lines.h"
#include "core/centreline/skeleton.h"

namespace angiomesh {

/// Voxels, as numbers of a VoxelSet, from node to node.
struct Chain {
  int from = 0, to = 0;
  std::vector<std::uint32_t> voxels;  ///< one or more; neighbours but for where a ring closes
};

/// The paths of one part, split where they meet.
struct ChainGraph {
  struct Node {
    NodeKind kind = NodeKind::Tip;
    std::uint32_t voxel = 0;
    int chains = 0;  ///< ends of chains here
  };
  std::vector<Node> nodes;
  std::vector<Chain> chains;
};

/// Joints are moved to where the vessels part, branches whose tips' balls have their centres
/// less than 2 working voxels outside the junction's ball, or less than the tip's radius and half
/// of the junction's, left out, chains that meet two by two made one.
ChainGraph chainsOf(const CentreLines& lines, const VoxelSet& set,
                    const std::vector<CentreLines::Path>& paths);

}  // namespace angiomesh

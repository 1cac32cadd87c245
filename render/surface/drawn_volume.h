// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// Cells along each side of a block.
constexpr int kBlockCells = 8;

/// A volume as it is drawn in 3D: with the least and the greatest value of each block of its cells,
/// by which rays leave out what is not seen.
struct DrawnVolume {
  std::shared_ptr<const Volume<float>> image;  ///< at least 2 voxels along each axis
  Index3 blocks{0, 0, 0};
  std::vector<float> least, greatest;   ///< by block, x fastest
  std::array<double, 2> bright{0, 1};   ///< of the voxels' values, fractions 0.9 and 0.9995
  std::array<double, 2> vessels{0, 1};  ///< fractions that suit bright vessels: 0.97 and 0.998
};

/// Goes through all voxels, which any thread may. @returns null where there is nothing to draw
std::shared_ptr<const DrawnVolume> drawnVolume(std::shared_ptr<const Volume<float>> image);

}  // namespace angiomesh

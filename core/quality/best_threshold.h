// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/image/volume.h"

namespace angiomesh {

/// What a threshold reaches that is chosen with the truth in hand.
struct BestThreshold {
  double overlap = 0.0;      ///< percent, eq. 5.3
  double sigmaVoxels = 0.0;  ///< of the Gaussian before it, voxels of each axis; 0: none
  double threshold = 0.0;    ///< intensity, of the smoothed image
};

/// The threshold, and the Gaussian (of 0 and 0.3 to 1 voxel in steps of 0.1) before it, with the
/// greatest overlap with `truth`: what a segmentation has to beat. A voxel above the threshold is
/// inside. Thresholds in 4096 steps over the range of intensities.
BestThreshold bestThreshold(const Volume<float>& image, const Volume<std::uint8_t>& truth);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/levelset/cell_band.h"

namespace angiomesh {

/// A weighted mean of a value over the surroundings of each cell of a band (Gaussian of about 8
/// voxels, on blocks of 4^3 voxels), drawn towards the mean over all where there is little weight.
/// Where all weights are 0: 0.
std::vector<float> localMean(const CellBand& band, const std::vector<float>& value,
                             const std::vector<float>& weight);

}  // namespace angiomesh

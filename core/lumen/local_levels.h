// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/distance/cell_band.h"

namespace angiomesh {

/// A weighted mean of a value over the surroundings of each cell of a band (Gaussian of about 8
/// voxels, on blocks of 4^3 voxels), drawn towards the mean over all where there is little weight.
/// Where all weights are 0: 0.
std::vector<float> localMean(const CellBand& band, const std::vector<float>& value,
                             const std::vector<float>& weight);

/// The mean of `value` along vessels: over the cells of `set` that are near each other by way of
/// the set, by `weight`: `steps` averages over a voxel and its 26-neighbours, each 2/3 voxel^2.
/// Where there is little weight it is `prior`. Cells outside the set have the mean of their
/// neighbours.
std::vector<float> meanAlong(const CellBand& band, const std::vector<char>& set,
                             const std::vector<float>& value, const std::vector<float>& weight,
                             int steps, const std::vector<float>& prior);

}  // namespace angiomesh

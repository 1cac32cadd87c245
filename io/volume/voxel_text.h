// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "io/volume/voxel_data.h"

namespace angiomesh {

/// The values of voxels written as text, in this machine's byte order; `more`: how many stand
/// behind them. @throws IoError (unreadable, too few), InputError (one is no number of that type)
std::vector<std::byte> bytesOfText(const VoxelData& data, std::uintmax_t& more,
                                   const Progress& progress);

}  // namespace angiomesh

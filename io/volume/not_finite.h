// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/volume/any_volume.h"

namespace angiomesh {

/// Voxels that are not a number or minus infinity become the least finite value of the volume,
/// those that are infinity the greatest. Returns a warning that counts them, "" where there are
/// none; where no voxel is finite nothing is changed and nothing returned.
std::string replaceNotFinite(Volume<float>& volume);
std::string replaceNotFinite(AnyVolume& volume);

}  // namespace angiomesh

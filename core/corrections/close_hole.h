// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/image/voxel_box.h"

namespace angiomesh {

/// Fills the cavity of phi < 0 around a place in mm LPS, or else the hole through a vessel that is
/// nearest to it: at most 12 voxels off, and where voxels closed it is a membrane in its narrowest
/// section. Cavities of more than 100,000 voxels stay. phi changes at the filled voxels only: to be
/// redistanced.
/// @returns the box of the voxels that changed   @throws InputError: there is none   @throws
/// Cancelled
VoxelBox fillHole(Volume<float>& phi, const Eigen::Vector3d& placeLps,
                  const Progress& progress = {});

/// Cuts the loop of phi < 0 whose thinnest section is nearest to a place, at most 12 voxels off, in
/// that section. Likewise.
VoxelBox openLoop(Volume<float>& phi, const Eigen::Vector3d& placeLps,
                  const Progress& progress = {});

}  // namespace angiomesh

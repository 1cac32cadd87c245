// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/image/voxel_box.h"

namespace angiomesh {

/// Takes out of phi < 0 what lies beyond a plane across the vessel at a place: on the side of the
/// normal, and all that is connected to it other than through the vessel's section. The plane
/// becomes the vessel's flat end. phi is a distance near that only: to be redistanced.
/// @param placeLps mm, in the vessel or at most 2 working voxels beside it
/// @returns the box of the voxels that changed
/// @throws InputError: there is no vessel, or both sides are connected by another way
VoxelBox cutOff(Volume<float>& phi, const Eigen::Vector3d& placeLps,
                const Eigen::Vector3d& normalLps);

/// The same across the vessel's axis; of the two sides the one of fewer voxels is taken out.
VoxelBox cutOffSmallerSide(Volume<float>& phi, const Eigen::Vector3d& placeLps);

}  // namespace angiomesh

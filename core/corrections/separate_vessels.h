// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/corrections/tube_shape.h"

namespace angiomesh {

/// The gap between two vessels that touch, each given by a place in it: where ways from the one and
/// from the other cost the same, around the middle between the places. A way through the middle of
/// a bright vessel is cheap; one that is near a wall or dark is dear, as it is in the valley
/// between them. The gap is 1.8 working voxels wide, so that no voxels touch across it.
/// @param image on phi's grid, bright vessels or dark ones by `sign` = 1 or -1; of a segmentation
/// null
/// @throws InputError: there is no vessel within 3 working voxels of a place, they do not touch
/// around there, both places have one middle, or they lie too far apart   @throws Cancelled
Shape gapBetween(const Volume<float>* image, float sign, const Volume<float>& phi,
                 const Eigen::Vector3d& oneLps, const Eigen::Vector3d& otherLps,
                 const Progress& progress = {});

}  // namespace angiomesh

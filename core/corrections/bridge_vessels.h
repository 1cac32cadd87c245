// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/corrections/tube_shape.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

/// A tube from one vessel to another along the way between two places that has most vesselness: the
/// least sum of a step's length over its share of the largest vesselness around. Its radius changes
/// evenly from that of the one vessel, the largest ball in it near the place, to that of the other.
/// @param image on phi's grid; of a segmentation null: the way is straight then
/// @throws InputError: there is no vessel within 3 working voxels of a place, or they lie too far
/// apart   @throws Cancelled
Shape bridgeBetween(const Volume<float>* image, const VesselnessParams& params,
                    const Volume<float>& phi, const Eigen::Vector3d& fromLps,
                    const Eigen::Vector3d& toLps, const Progress& progress = {});

}  // namespace angiomesh

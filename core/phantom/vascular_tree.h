// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/phantom/shape.h"

namespace angiomesh {

/// Trees of straight vessels that fill the volume, see growVessels(); the truth mask holds
/// `volumePercent` of the voxels. The number of vessels follows from that, unless
/// `params.terminals` is given: then the share is met as far as the range of radii allows.
/// @throws InputError when the volume is too small or the parameters contradict one another
Shape vascularTree(const PhantomParams& params, const Geometry& geometry, const Progress& progress);

}  // namespace angiomesh

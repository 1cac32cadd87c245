// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// I_t = kappa |grad I| (ITK's curvature flow filter). Same grid as the input.
/// @param timeStep squared voxels, of the shortest spacing: what is smoothed does not depend on the
/// unit or the size of the voxels, only on their shape
Volume<float> curvatureFlow(const Volume<float>& image, int iterations, double timeStep,
                            const Progress& progress = {});

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// I_t = kappa |grad I| (ITK's curvature flow filter), in physical spacing. Same grid as the input.
Volume<float> curvatureFlow(const Volume<float>& image, int iterations, double timeStep,
                            const Progress& progress = {});

}  // namespace angiomesh

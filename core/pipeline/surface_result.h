// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// What the step surface makes of a segmentation: the kept parts without what cuts take, their
/// surface before smoothing, and its ports.
/// @param warned is told beforehand what the surface will cost
/// @throws InputError, NumericError (nothing is left), Cancelled
SurfaceResult surfaceOf(const EvolveResult& evolved, const Parameters& params,
                        const Progress& progress, std::vector<std::string>& warnings,
                        const std::function<void(const std::string&)>& warned);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/pipeline/step_results.h"
#include "core/vesselness/speed.h"

namespace angiomesh {

/// @throws InputError (no contrast), Cancelled
VesselnessResult computeVesselness(const Volume<float>& image, const VesselnessParams& params,
                                   const Progress& progress);

/// Those by hand, and the automatic ones from the vesselness at the middle scale, which nothing
/// else needs. @throws InputError, NumericError, Cancelled
SeedsResult computeSeeds(const Volume<float>& image, const VesselnessResult& vessels,
                         const Parameters& params, const Progress& progress);

/// a and b as the evolve step takes them. @throws NumericError
Thresholds thresholdsFor(const VesselnessResult& vessels, const ThresholdParams& params);

/// p of eq. 3.21 at each voxel of the vesselness.
Volume<float> speedVolume(const Volume<float>& vesselness, const Thresholds& thresholds);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/phantom/appearance.h"
#include "core/phantom/point_spread.h"
#include "core/phantom/rasterise.h"

namespace angiomesh {

/// `grid` with a margin as wide as the point spread reaches, so that what lies just beyond the
/// volume is seen in it.
Geometry withMargin(const Geometry& grid, const PointSpread& psf);

/// The shape, 255 inside and 0 outside, seen through a point spread (Gaussian or Mr).
/// @param volumes of the shape on withMargin(grid, psf), soft where isWide(psf, grid)
/// @param fade the brightness of each place, 0..1; nullptr: 1
/// Separable; places away from the shape cost nothing. The same for any number of threads.
Volume<float> seenThrough(const PointSpread& psf, const PartialVolumes& volumes,
                          const VesselFade* fade, const Geometry& grid, const Progress& progress);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/vesselness/vesselness.h"

namespace angiomesh {

/// Radius in mm of the largest ball that fits into what lies beyond half-way between the median and
/// the 99.9th percentile (0.1th for dark vessels) of the image averaged over blocks of about four
/// working voxels: of the thickest vessel, or of whatever is as bright and thicker; up to a block
/// too small; 46 working voxels at most. 0 when nothing, or everything, is so bright.
double thickestRadiusMm(const Volume<float>& image, Polarity polarity);

/// The parameters with sigmaMaxMm by the image, where it was left open: half of the thickest radius
/// (a vessel of twice the largest scale is still found whole), from 6 to 15 working voxels.
VesselnessParams withScalesFromImage(VesselnessParams params, const Volume<float>& image);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// One z slice of the six second derivatives {xx, yy, zz, xy, xz, yz} per mm^2 in index axes at
/// scale sigma, times sigma^2: discrete Gaussian (Lindeberg 1990; error 0.01, radius at most 30),
/// then central differences of step sigma with linear interpolation, borders clamped (thesis 5.1).
using HessianSlice = std::array<const float*, 6>;

/// Computes the derivatives slice by slice and hands each slice to `consume(k, slice)`, in parallel
/// and in no particular order. Works in slabs: no volume is kept.
void forEachHessianSlice(const Volume<float>& image, double sigmaMm,
                         const std::function<void(int k, const HessianSlice& slice)>& consume,
                         const Progress& progress);

/// Smooths by a Gaussian (samples beyond the border are those at it) and hands each z slice to
/// `consume(k, slice)`, in parallel and in no particular order. No volume is kept.
void forEachSmoothSlice(const Volume<float>& image, double sigmaMm,
                        const std::function<void(int k, const float* slice)>& consume,
                        const Progress& progress);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace angiomesh {

/// Half of the discrete Gaussian kernel e^-t I_n(t) (Lindeberg 1990) of the given variance in
/// samples^2, n = 0 .. radius, with the smallest radius that leaves at most `maximumError` of the
/// sum out, at most `maximumRadius`; normalised so that the whole kernel sums to 1.
std::vector<float> discreteGaussian(double variance, double maximumError = 0.01,
                                    int maximumRadius = 30);

}  // namespace angiomesh

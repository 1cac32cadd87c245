// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/volume/any_volume.h"

namespace angiomesh {

/// Makes labels of what other programs leave of them, in place:
/// - with a threshold: 1 where a value is not less, else 0, whatever the values are;
/// - values at most 0.05 off whole numbers are rounded;
/// - values of -0.35 to 1.35, as of probabilities and of resampled masks, are 1 from 0.5 on, else
/// 0;
/// - not-a-number is 0.
/// Other values stay. Returns warnings that say what was done.
std::vector<std::string> makeLabels(AnyVolume& volume, std::optional<double> threshold = {});
std::vector<std::string> makeLabels(Volume<float>& volume);

/// Whether no value is more than 0.05 off a whole number.
bool areNearlyWhole(const Volume<float>& volume);

/// Of a float image with values of both signs: most of them lie near 0 on the scale of the greatest
/// one, as in a resampled mask and in no level set function.
bool looksLikeResampledMask(const Volume<float>& volume);

}  // namespace angiomesh

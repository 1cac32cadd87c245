// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// Sentences on what is most likely wrong with a segmentation and what to do about it: parts whose
/// surroundings are brighter than they are (see brighterAround()), and vessels full of holes.
/// @param image as it came, before preprocessing: bounds of its intensity take bone away, but not
/// what it encloses
/// @param c of the vesselness that led to the segmentation
std::vector<std::string> segmentationDoubts(const Volume<float>& image, const EvolveResult& result,
                                            const Parameters& params, double c);

}  // namespace angiomesh

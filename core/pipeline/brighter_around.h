// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/volume.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

/// How much of its surroundings, two working voxels off its wall, is brighter than a part of a
/// segmentation on average (darker, where vessels are dark): 0 to 1 for each of the labels 1..count
/// of `labels`. Around a vessel next to nothing is, around the marrow of a bone nearly all.
/// @param image on any grid: its nearest voxel counts
/// @param phi negative inside, with a slope at the wall, on the grid of `labels`
std::vector<double> brighterAround(const Volume<float>& image, const Volume<float>& phi,
                                   const Volume<std::int32_t>& labels, std::size_t count,
                                   Polarity polarity);

}  // namespace angiomesh

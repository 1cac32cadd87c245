// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// What the step evolve makes of the preprocessed image, by segmentation.method. `vessels` is let
/// go as soon as it is of no more use.
/// @throws InputError, NumericError (nothing is left), Cancelled
EvolveResult makeSegmentation(const Volume<float>& image,
                              std::shared_ptr<const VesselnessResult> vessels,
                              const SeedsResult& seeds, const Parameters& params,
                              const RunOptions& options, const Progress& progress,
                              std::vector<std::string>& warnings);

/// The same of a segmentation: the voxels of segmentation.label as a smooth distance. Values that
/// are no whole numbers are rounded, with a warning.
/// @throws InputError (no such voxels, or nothing else), Cancelled
EvolveResult takeLabel(const Volume<float>& image, const Parameters& params,
                       const Progress& progress, std::vector<std::string>& warnings);

}  // namespace angiomesh

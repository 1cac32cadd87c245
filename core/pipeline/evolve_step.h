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

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "core/sensitivity/wall_moves.h"

namespace angiomesh {

/// What sliders and suggestions go by, of a run as far as the evolution.
FieldContext contextOf(const RunResult& run);

/// A parameter by a step up or down.
struct ParameterStep {
  std::string key;
  bool up = false;
  double from = 0.0, to = 0.0;
  Parameters params;  ///< with the step made, and partners that had to follow
};

/// A step up and one down of each numeric parameter that the segmentation of a scan depends on, the
/// parameters of late steps first, as these leave most to be computed once. A step is a tenth of
/// the range of the parameter's slider or, where that moves in equal ratios, a factor of 1.25,
/// times `size`. One that is empty starts from what it stands for. What leaves its range is left
/// out.
/// @param keys empty: all main ones that have an effect
/// @throws InputError: a key that is not known, or no number of the segmentation
std::vector<ParameterStep> parameterSteps(const Parameters& params, const FieldContext& context,
                                          const std::vector<std::string>& keys = {},
                                          double size = 1.0);

/// What a step does to the segmentation.
struct StepEffect {
  ParameterStep step;
  WallMoves moves;
  std::string why;  ///< there is no such segmentation; empty: there is
};

/// How much a segmentation depends on its parameters.
struct Sensitivity {
  std::shared_ptr<const EvolveResult> segmentation;  ///< without any step
  WallPlaces places;                                 ///< on its wall
  std::vector<StepEffect> effects;                   ///< in the order of the steps
  /// At each place the largest move of all steps, mm; of a vessel that is lost the limit.
  std::vector<float> spreadMm;
};

/// Runs the pipeline as far as the corrections for each step. Every result is the same as of a run
/// by itself.
/// @param made called after each step, with its number
/// @throws as Pipeline::run() without any step, Cancelled
Sensitivity sensitivityOf(Pipeline& pipeline, const Parameters& params,
                          const std::vector<ParameterStep>& steps, const Progress& progress = {},
                          const std::function<void(std::size_t)>& made = {});

}  // namespace angiomesh

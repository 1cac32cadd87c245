// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/pipeline/run_options.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// A step's result, as the pipeline remembers it.
using StepValue =
    std::variant<std::monostate, std::shared_ptr<const Volume<float>>,
                 std::shared_ptr<const VesselnessResult>, std::shared_ptr<const SeedsResult>,
                 std::shared_ptr<const EvolveResult>, std::shared_ptr<const SurfaceResult>,
                 std::shared_ptr<const TriMesh>, std::shared_ptr<const QualityResult>>;

/// What a step's function works with.
struct StepWork {
  const RunOptions& options;
  RunResult& run;  ///< with the parameters, and the results of the steps before
  Progress progress;
  std::vector<std::string> warnings;  ///< of the step in work
  /// A result that is remembered of a step with other parameters; none where there is none.
  std::function<StepValue(Step step, const Parameters& params)> remembered;
  std::optional<SplineField> wallOnce = {};

  [[nodiscard]] const Parameters& params() const { return run.params; }
  /// The field whose zero set the surface follows, made once for a run.
  const SplineField& wall();
};

/// A step's functions; what else is known of it stands in kSteps.
struct StepRow {
  Step step = Step::Load;
  /// @throws InputError, NumericError, Cancelled
  StepValue (*make)(StepWork& work) = nullptr;
  /// Puts a result, made or remembered, where the steps after it find it.
  void (*store)(RunResult& run, const StepValue& value) = nullptr;
  /// What is done in each run with a result that is not part of it; may be null.
  void (*finish)(RunResult& run) = nullptr;
};

/// The steps after Load, in order.
const std::vector<StepRow>& stepTable();

}  // namespace angiomesh

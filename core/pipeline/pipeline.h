// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/pipeline/run_options.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// Runs the steps on one source and keeps their results by key: a step whose key is known is not
/// computed again. One run at a time; all else may be called from any thread.
class Pipeline {
 public:
  explicit Pipeline(Source source);
  ~Pipeline();

  /// @throws InputError, NumericError, Cancelled; see RunOptions::keepOnFailure
  RunResult run(const Parameters& params, const RunOptions& options = {},
                const Progress& progress = {});

  /// The key that `step` has with these parameters: a hash of its id, version, parameters and
  /// inputs.
  [[nodiscard]] std::string key(Step step, const Parameters& params) const;

  /// The key of the speed p, which hangs on the vesselness and the fields that set its thresholds.
  [[nodiscard]] std::string speedKey(const Parameters& params) const;

  /// Whether the step's result with these parameters is at hand.
  [[nodiscard]] bool has(Step step, const Parameters& params) const;

  /// Whether a run up to `until` makes or takes the step's result: not where the image is a
  /// segmentation that the step does nothing to, nor where only the evolution needs it, whose
  /// result is at hand.
  [[nodiscard]] bool needs(Step step, const Parameters& params, Step until = Step::Quality) const;

  /// The last step up to which a run would compute nothing.
  [[nodiscard]] Step deepestAtHand(const Parameters& params) const;

  /// Takes a result that an earlier pipeline computed from the same source and parameters. What
  /// the evolution alone needs, vesselness and seeds, is then not computed for a run beyond it, and
  /// empty in its result. False, and nothing is taken, unless `report.key` is the step's key.
  bool restore(std::shared_ptr<const EvolveResult> evolve, const StageReport& report,
               const Parameters& params);

  [[nodiscard]] const Source& source() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace angiomesh

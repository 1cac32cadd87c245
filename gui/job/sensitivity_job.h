// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/sensitivity/sensitivity.h"

namespace angiomesh {

/// A sensitivity, ready to be drawn.
struct DrawnSensitivity {
  Sensitivity found;
  std::shared_ptr<const TriMesh> wall;  ///< of found.places
  std::vector<float> spread;            ///< of each triangle, mm: the largest of its corners
  /// Of each effect and triangle, mm, outwards positive: the mean of its corners. Empty where there
  /// is no such segmentation.
  std::vector<std::vector<float>> moves;
  double scaleMm = 0.0;  ///< 98 % of the spread is less, and so is this
};

/// Tries each main parameter a step up and down, see sensitivityOf(), with a pipeline of its own.
struct SensitivityJob {
  Source source;
  Parameters params;
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::shared_ptr<const DrawnSensitivity> drawn;  ///< null where it failed or was cancelled
  std::string error;                              ///< empty: it did not fail
  double seconds = 0.0;
};

}  // namespace angiomesh

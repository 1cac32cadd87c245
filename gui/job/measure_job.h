// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/skeleton.h"
#include "core/field/spline_field.h"
#include "core/measure/measurement.h"

namespace angiomesh {

/// What is measured in. The parts after the key are made by the first job that needs them.
struct MeasureGround {
  std::shared_ptr<const Volume<float>> phi;  ///< of the step evolve, mm; null: nothing is there yet
  std::string key;                           ///< of that step
  std::shared_ptr<const SplineField> wall;
  std::shared_ptr<const Skeleton> skeleton;
};

/// Measures at the places picked: execute() on the worker, the results after it.
struct MeasureJob {
  MeasureGround ground;
  Measurement measurement;  ///< kind, name and places; after execute() all of it
  std::string edit;         ///< what it is called when undone
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::string error;  ///< empty: it is measured, or was cancelled

 private:
  void measure();
  void prepare(bool withSkeleton);
};

/// Writes measurements as a table, see writeMeasurements().
struct MeasurementsFileJob {
  std::filesystem::path path;
  std::vector<Measurement> measurements;
  std::string key;  ///< of the present parameters' step evolve

  void execute() noexcept;

  // After execute():
  std::string error;
};

}  // namespace angiomesh

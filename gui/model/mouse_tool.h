// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/measure/measurement.h"

namespace angiomesh {

/// What a plain left click or drag does in a slice pane. The tools that measure come last, in the
/// order of MeasurementKind.
enum class Tool {
  Navigate,
  PickSeed,
  DrawRoi,
  CutVessel,
  MeasureDistance,
  MeasureSection,
  MeasureProfile,
  MeasureStenosis
};

constexpr Tool toolFor(MeasurementKind kind) {
  return static_cast<Tool>(static_cast<int>(Tool::MeasureDistance) + static_cast<int>(kind));
}

/// What a tool measures; nothing: it does something else.
constexpr std::optional<MeasurementKind> measuredBy(Tool tool) {
  const int number = static_cast<int>(tool) - static_cast<int>(Tool::MeasureDistance);
  if (number < 0) return std::nullopt;
  return static_cast<MeasurementKind>(number);
}

/// What the left button does with Tool::Navigate: window/level, or the crosshair.
enum class MouseScheme { Radiology, Engineering };

}  // namespace angiomesh

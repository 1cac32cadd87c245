// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/corrections/correction.h"
#include "core/measure/measurement.h"

namespace angiomesh {

/// What a plain left click or drag does in a slice pane. The tools that measure come last, in the
/// order of MeasurementKind.
enum class Tool {
  Navigate,
  PickSeed,
  DrawRoi,
  CutVessel,
  BrushAdd,
  BrushErase,
  JoinEnds,
  SeparateVessels,
  MeasureDistance,
  MeasureSection,
  MeasureProfile,
  MeasureStenosis
};

constexpr Tool toolFor(MeasurementKind kind) {
  return static_cast<Tool>(static_cast<int>(Tool::MeasureDistance) + static_cast<int>(kind));
}

/// Whether a drag paints.
constexpr bool isBrush(Tool tool) { return tool == Tool::BrushAdd || tool == Tool::BrushErase; }

/// What a tool corrects with its clicks, the brushes apart; nothing: it does something else.
constexpr std::optional<CorrectionKind> correctedBy(Tool tool) {
  if (tool == Tool::JoinEnds) return CorrectionKind::Bridge;
  if (tool == Tool::SeparateVessels) return CorrectionKind::Separate;
  return std::nullopt;
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

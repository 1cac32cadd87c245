// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <optional>

#include "gui/job/display_facts.h"

namespace angiomesh {

/// How far window and level of a layer may go, in its values.
struct WindowLimits {
  double least = 0.0, greatest = 1.0;  ///< of the values; least < greatest
  double usual = 1.0;                  ///< a window that suits them

  [[nodiscard]] double smallestWindow() const { return usual / 4000.0; }
  [[nodiscard]] double largestWindow() const { return 4.0 * (greatest - least); }
  [[nodiscard]] double lowestLevel() const { return least - (greatest - least); }
  [[nodiscard]] double highestLevel() const { return greatest + (greatest - least); }
  [[nodiscard]] WindowLevel bounded(const WindowLevel& wanted) const;

  bool operator==(const WindowLimits&) const = default;
};

/// Of the image itself.
WindowLimits imageLimits(const DisplayFacts& facts);

/// Windows that are chosen by name; from Cta on they are for CT, in HU.
enum class WindowPreset { File, Percentiles, Cta, SoftTissue, Brain, Bone };
constexpr int kWindowPresetCount = 6;

/// "Soft tissue (400 / 40)".
QString windowPresetTitle(WindowPreset preset);

/// Nothing where it makes no sense: the file states none, the image is no CT, or its values are far
/// from those of the preset.
std::optional<WindowLevel> presetWindow(WindowPreset preset, const DisplayFacts& facts);

}  // namespace angiomesh

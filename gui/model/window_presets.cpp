// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/window_presets.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cstddef>

namespace angiomesh {

namespace {

struct Row {
  const char* title;
  WindowLevel hounsfield;  // of a preset for CT
};

/// In the order of WindowPreset.
constexpr std::array<Row, kWindowPresetCount> kRows{
    {{QT_TRANSLATE_NOOP("WindowPreset", "From the file"), {}},
     {QT_TRANSLATE_NOOP("WindowPreset", "1st to 99.8th percentile"), {}},
     {QT_TRANSLATE_NOOP("WindowPreset", "CT angiography"), {600.0, 200.0}},
     {QT_TRANSLATE_NOOP("WindowPreset", "Soft tissue"), {400.0, 40.0}},
     {QT_TRANSLATE_NOOP("WindowPreset", "Brain"), {80.0, 40.0}},
     {QT_TRANSLATE_NOOP("WindowPreset", "Bone"), {1500.0, 300.0}}}};

const Row& rowOf(WindowPreset preset) { return kRows[static_cast<std::size_t>(preset)]; }

}  // namespace

WindowLevel WindowLimits::bounded(const WindowLevel& wanted) const {
  return {std::clamp(wanted.first, smallestWindow(), largestWindow()),
          std::clamp(wanted.second, lowestLevel(), highestLevel())};
}

WindowLimits imageLimits(const DisplayFacts& facts) {
  WindowLimits limits{facts.values[0], facts.values[1], facts.percentileWindow.first};
  if (!(limits.greatest > limits.least)) limits.greatest = limits.least + 1.0;
  const auto include = [&limits](const WindowLevel& stated) {
    const auto [window, level] = stated;
    limits.least = std::min(limits.least, level - 0.5 * window);
    limits.greatest = std::max(limits.greatest, level + 0.5 * window);
  };
  if (facts.fileWindow) include(*facts.fileWindow);
  for (const auto& [window, name] : facts.otherFileWindows) include(window);
  limits.usual = std::min(limits.usual, limits.greatest - limits.least);
  return limits;
}

QString windowPresetTitle(WindowPreset preset) {
  const Row& row = rowOf(preset);
  const QString title = QCoreApplication::translate("WindowPreset", row.title);
  const auto [window, level] = row.hounsfield;
  return window > 0.0 ? QStringLiteral("%1 (%2 / %3)").arg(title).arg(window).arg(level) : title;
}

std::optional<WindowLevel> presetWindow(WindowPreset preset, const DisplayFacts& facts) {
  if (preset == WindowPreset::File) return facts.fileWindow;
  if (preset == WindowPreset::Percentiles) return facts.percentileWindow;
  const WindowLevel window = rowOf(preset).hounsfield;
  // A file need not tell its modality; its values then do.
  const bool mayBeCt = facts.modality == "CT" || facts.modality.empty();
  if (!mayBeCt || imageLimits(facts).bounded(window) != window) return std::nullopt;
  return window;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/display_facts.h"

#include <algorithm>

#include "render/slice/slice_raster.h"

namespace angiomesh {

namespace {

constexpr double kLowFraction = 0.01, kHighFraction = 0.998;

std::optional<WindowLevel> windowBetween(double low, double high) {
  if (!(high > low)) return std::nullopt;
  return WindowLevel(high - low, 0.5 * (low + high));
}

}  // namespace

DisplayFacts displayFacts(const Volume<float>& image, const InputInfo& info) {
  DisplayFacts facts;
  facts.modality = info.modality;
  const auto extremes = valueRange(image);
  facts.values = {extremes[0], extremes[1]};
  for (const DisplayWindow& stated : info.windows) {
    const auto ends = stated.range();
    const std::optional<WindowLevel> window = windowBetween(ends[0], ends[1]);
    if (!window) continue;
    if (!facts.fileWindow)
      facts.fileWindow = window;
    else
      facts.otherFileWindows.emplace_back(*window, stated.name);
  }
  // All voxels where parameters are suggested from them; else a sample is good enough, and is had
  // without a sorted copy of a large volume.
  std::array<double, 2> range{};
  if (facts.fileWindow) {
    range = displayRange(image, kLowFraction, kHighFraction);
    range[1] = std::min(range[1], facts.values[1]);  // it ends higher where all values are equal
  } else {
    const std::vector<double> exact = percentiles(image, {kLowFraction, kHighFraction});
    range = {exact[0], exact[1]};
  }
  facts.percentileWindow =
      windowBetween(range[0], range[1])
          .value_or(windowBetween(extremes[0], extremes[1]).value_or(facts.percentileWindow));
  return facts;
}

}  // namespace angiomesh

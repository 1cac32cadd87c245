// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/image/volume.h"
#include "io/volume/loaded_image.h"

namespace angiomesh {

/// Window and level: the values from level - window / 2 to level + window / 2 go from black to
/// white.
using WindowLevel = std::pair<double, double>;

/// What a viewer has to know of an image, in the image's values.
struct DisplayFacts {
  std::string modality;                    ///< InputInfo::modality
  std::array<double, 2> values{0.0, 1.0};  ///< least and greatest
  std::optional<WindowLevel> fileWindow;   ///< the first one that the file states
  /// The others, with what the file calls them, which may be nothing.
  std::vector<std::pair<WindowLevel, std::string>> otherFileWindows;
  WindowLevel percentileWindow{1.0, 0.5};  ///< from the 1st to the 99.8th percentile

  /// To begin with.
  [[nodiscard]] WindowLevel window() const { return fileWindow.value_or(percentileWindow); }
};

/// Goes through the image, which must not be empty.
DisplayFacts displayFacts(const Volume<float>& image, const InputInfo& info);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace angiomesh {

/// As printf() writes it.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// "a, b or c".
std::string eitherOf(const std::vector<std::string>& words);

/// The shortest text that reads back as the same number.
std::string shortestText(double value);

/// "a, b, c": of each of them its `text`, a member or a function.
template <class Range, class Text = std::identity>
std::string joined(const Range& all, const char* between = ", ", const Text& text = {}) {
  std::string line;
  for (const auto& each : all) {
    if (!line.empty()) line += between;
    line += std::invoke(text, each);
  }
  return line;
}

/// A place as readers of images say it: "L 12.3 A 4.5 S 67.8 mm".
std::string placeText(const Eigen::Vector3d& pointLps);

}  // namespace angiomesh

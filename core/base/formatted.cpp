// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/formatted.h"

#include <array>
#include <charconv>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <span>

namespace angiomesh {

std::string formatted(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(values);
  return text;
}

std::string eitherOf(const std::vector<std::string>& words) {
  const std::string before = joined(std::span(words).first(words.size() - 1));
  return before.empty() ? words.back() : before + " or " + words.back();
}

std::string shortestText(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string placeText(const Eigen::Vector3d& pointLps) {
  const Eigen::Vector3d length = pointLps.cwiseAbs();
  return formatted("%c %.1f %c %.1f %c %.1f mm", pointLps[0] < 0.0 ? 'R' : 'L', length[0],
                   pointLps[1] < 0.0 ? 'A' : 'P', length[1], pointLps[2] < 0.0 ? 'I' : 'S',
                   length[2]);
}

}  // namespace angiomesh

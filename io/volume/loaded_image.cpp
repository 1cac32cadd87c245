// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/loaded_image.h"

#include <algorithm>

namespace angiomesh {

std::array<double, 2> DisplayWindow::range() const {
  // PS3.3 C.11.2.1.2.1: the plain linear function is off by half a step and one step.
  if (function == "LINEAR" && width > 1.0)
    return {level - 0.5 - 0.5 * (width - 1.0), level - 0.5 + 0.5 * (width - 1.0)};
  return {level - 0.5 * width, level + 0.5 * width};
}

std::vector<std::string> reportWarnings(const InputInfo& info) {
  std::vector<std::string> texts = info.warnings;
  for (const Finding& finding : info.findings) texts.push_back(finding.text);
  return texts;
}

std::vector<std::string> screenWarnings(const InputInfo& info) {
  std::vector<std::string> texts = info.warnings;
  for (const Finding& finding : info.findings) texts.push_back(screenText(finding));
  return texts;
}

const Finding* ImageSummary::refusal() const {
  const auto found = std::find_if(info.findings.begin(), info.findings.end(),
                                  [](const Finding& finding) { return finding.refuses; });
  return found != info.findings.end() ? &*found : nullptr;
}

}  // namespace angiomesh

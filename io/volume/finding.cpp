// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/finding.h"

#include <array>

namespace angiomesh {

std::string findingWord(FindingKind kind) {
  static constexpr std::array words{
      "missing-slices", "uneven-spacing", "duplicate-position", "mixed-orientation",
      "mixed-size",     "mixed-spacing",  "mixed-reference",    "repeated-uid",
      "gantry-tilt",    "shifted-slices", "no-position",        "several-volumes",
      "colour-image",   "mosaic-image",   "segmentation",       "single-slice",
      "damaged-file",   "repeated-file",  "varying-rescale",    "inverted-values",
      "padded-values",  "value-table"};
  static_assert(words.size() == static_cast<std::size_t>(FindingKind::ValueTable) + 1);
  return words[static_cast<std::size_t>(kind)];
}

bool canBeEvenedOut(FindingKind kind) {
  return kind == FindingKind::MissingSlices || kind == FindingKind::UnevenSpacing;
}

std::string screenText(const Finding& finding) {
  return finding.names.empty() ? finding.text : finding.text + " (" + finding.names + ")";
}

}  // namespace angiomesh

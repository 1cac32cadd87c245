// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/finding.h"

namespace angiomesh {

std::string findingWord(FindingKind kind) {
  switch (kind) {
    case FindingKind::MissingSlices:
      return "missing-slices";
    case FindingKind::UnevenSpacing:
      return "uneven-spacing";
    case FindingKind::DuplicatePosition:
      return "duplicate-position";
    case FindingKind::MixedOrientation:
      return "mixed-orientation";
    case FindingKind::MixedSize:
      return "mixed-size";
    case FindingKind::MixedSpacing:
      return "mixed-spacing";
    case FindingKind::MixedReference:
      return "mixed-reference";
    case FindingKind::RepeatedUid:
      return "repeated-uid";
    case FindingKind::GantryTilt:
      return "gantry-tilt";
    case FindingKind::ShiftedSlices:
      return "shifted-slices";
    case FindingKind::NoPosition:
      return "no-position";
    case FindingKind::SeveralVolumes:
      return "several-volumes";
    case FindingKind::ColourImage:
      return "colour-image";
    case FindingKind::Segmentation:
      return "segmentation";
    case FindingKind::MosaicImage:
      return "mosaic-image";
    case FindingKind::SingleSlice:
      return "single-slice";
    case FindingKind::DamagedFile:
      return "damaged-file";
    case FindingKind::RepeatedFile:
      return "repeated-file";
    case FindingKind::VaryingRescale:
      return "varying-rescale";
    case FindingKind::InvertedValues:
      return "inverted-values";
    case FindingKind::PaddedValues:
      return "padded-values";
    case FindingKind::ValueTable:
      return "value-table";
  }
  return {};
}

bool canBeEvenedOut(FindingKind kind) {
  return kind == FindingKind::MissingSlices || kind == FindingKind::UnevenSpacing;
}

std::string screenText(const Finding& finding) {
  return finding.names.empty() ? finding.text : finding.text + " (" + finding.names + ")";
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace angiomesh {

/// findingWord() has their words in this order.
enum class FindingKind {
  MissingSlices,
  UnevenSpacing,
  DuplicatePosition,
  MixedOrientation,
  MixedSize,
  MixedSpacing,
  MixedReference,
  RepeatedUid,
  GantryTilt,
  ShiftedSlices,
  NoPosition,
  SeveralVolumes,
  ColourImage,
  MosaicImage,
  Segmentation,
  SingleSlice,
  DamagedFile,
  RepeatedFile,
  VaryingRescale,
  InvertedValues,
  PaddedValues,
  ValueTable
};

/// What stands between a DICOM series and a volume, or should be known of it.
struct Finding {
  FindingKind kind = FindingKind::DamagedFile;
  bool refuses = false;     ///< no volume can be made of the slices as they are
  std::string text;         ///< what and where, with slice numbers; holds no name of a file
  std::vector<int> slices;  ///< numbers of the slices in question, 1-based along the stack's normal
  std::string names;        ///< their files, for the screen only: file names may tell who it is
};

/// "missing-slices" and so on, as in the JSON of `info`.
std::string findingWord(FindingKind kind);

/// True when resampling to an even distance makes a volume of the slices.
bool canBeEvenedOut(FindingKind kind);

/// "text (names)", for the screen.
std::string screenText(const Finding& finding);

/// Slices are missing or uneven, and nothing else is wrong: the reader may be asked again to
/// resample them.
class UnevenSlicesError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace angiomesh

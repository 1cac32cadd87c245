// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/corrections/apply_correction.h"

namespace angiomesh {

/// What came of a correction.
struct CorrectionOutcome {
  std::string text;                    ///< as correctionText()
  std::size_t added = 0, removed = 0;  ///< voxels
  std::string why;                     ///< it was left out, a clause; empty: it was made

  bool operator==(const CorrectionOutcome&) const = default;
};

/// Makes corrections one after another, as parseCorrection() takes them. One that cannot be made,
/// as it may be on the segmentation of other parameters, is left out.
/// @throws InputError where parseCorrection() does, Cancelled
std::vector<CorrectionOutcome> replay(Volume<float>& phi, const std::vector<std::string>& texts,
                                      const CorrectionGround& ground,
                                      const Progress& progress = {});

/// A warning for each correction that was left out or changed nothing, with its number, from 1.
std::vector<std::string> warningsOf(const std::vector<CorrectionOutcome>& outcomes);

/// Another volume of the same segmentation, such as one before its wall was made smooth, with what
/// was corrected in `after`, which was `before`.
void carryOver(const Volume<float>& before, const Volume<float>& after, Volume<float>& other);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/measure/measurement.h"
#include "core/measure/review.h"

namespace angiomesh {

/// What the user noted in a case: nothing that a step computes depends on it.
struct CaseNotes {
  std::vector<Measurement> measurements;
  CaseReview review;

  bool operator==(const CaseNotes& other) const = default;
};

/// As case.json and the journal have them, an object in JSON. Numbers come back as they were.
std::string notesToJson(const CaseNotes& notes);

/// What cannot be used is left out, with a warning. Never throws.
CaseNotes notesFromJson(const std::string& text, std::vector<std::string>& warnings);

}  // namespace angiomesh

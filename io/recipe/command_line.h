// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/parameters/field.h"

namespace angiomesh {

/// The preset that parameters are nearest to, and what is another one than in it.
struct NearestPreset {
  std::string name;
  std::vector<const Field*> others;  ///< without places
};
NearestPreset nearestPreset(const Parameters& params);

/// A line for a POSIX shell that runs a volume with these parameters, with SCAN in place of the
/// volume: a path may tell the patient. What is as in the nearest preset is left out.
std::string commandLine(const Parameters& params);

}  // namespace angiomesh

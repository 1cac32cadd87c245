// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/parameters/parameters.h"

namespace angiomesh {

/// Parameters that have a name.
struct Preset {
  std::string name;
  std::string about;  ///< what it is for, one sentence; may be empty
  Parameters params;  ///< with no places
};

/// Those that come with the program, the default first.
const std::vector<Preset>& shippedPresets();

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "io/vessel/openfoam_case.h"

namespace angiomesh {

/// The texts of a case by their path in it: all but the surface.
std::map<std::string, std::string> openFoamTexts(const OpenFoamMesh& mesh);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/recipe/recipe_file.h"

namespace angiomesh {

struct CaseModels;

/// What repeats the open case: its parameters, and the volume that they are for. An evolution that
/// was ended by hand ends there. @pre there is a case
Recipe caseRecipe(const CaseModels& models);

/// methodsText() of the run that the meshes at hand come from; empty without one.
std::string caseMethods(const CaseModels& models);

}  // namespace angiomesh

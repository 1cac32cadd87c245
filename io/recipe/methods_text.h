// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/pipeline/step_results.h"

namespace angiomesh {

/// How a run made its surface, as a paragraph for a paper and the references in it: version,
/// volume, methods with the parameters that matter, what is another one than in the nearest preset,
/// mesh, and the hashes of recipe and mesh. English; no name, path, date or position is in it.
/// Empty where the run has no surface.
std::string methodsText(const RunResult& run);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/report.h"

namespace angiomesh {

const char* versionText() { return ANGIOMESH_VERSION; }

}  // namespace angiomesh

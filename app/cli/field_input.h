// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/image/volume.h"

namespace angiomesh::cli {

/// Reads a level set function, or a mask as the function that is -0.5 inside and 0.5 outside. A
/// file is a mask when none of its values is negative.
Volume<float> readPhiOrMask(const std::string& path);

}  // namespace angiomesh::cli

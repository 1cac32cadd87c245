// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace angiomesh {

/// @throws IoError unless a regular file can come to stand at `target`
void checkTarget(const std::filesystem::path& target);

}  // namespace angiomesh

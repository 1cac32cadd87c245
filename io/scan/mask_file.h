// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/image/volume.h"

namespace angiomesh {

/// Writes a mask by extension, as writeVolume() does, and reads it back: a file appears only where
/// it holds the same voxels on the same grid. @throws InputError, IoError: nothing is left behind
void writeMask(const Volume<std::uint8_t>& mask, const std::filesystem::path& path);

}  // namespace angiomesh

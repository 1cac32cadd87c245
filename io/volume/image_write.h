// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/image/volume.h"
#include "io/volume/any_volume.h"

namespace angiomesh {

/// Writes by extension: .mha, .nrrd and .nii.gz compressed, .nii plain, .mhd with a .raw beside it,
/// .nhdr with a .raw.gz. All but NIfTI keep the geometry to the last bit or the one before it;
/// NIfTI keeps it in float32 and holds no skewed axes and no side above 32767 voxels. Files get
/// temporary names, then are renamed: those of a pair so that no header ever stands beside other
/// voxels than its own, and a voxel file that belongs to something else is left alone (another name
/// is taken).
/// @throws InputError (a name or a geometry that the format does not hold), IoError (no such
/// folder, no permission, disk full): nothing is left behind
void writeVolume(const Volume<float>& volume, const std::filesystem::path& path);
void writeVolume(const Volume<std::uint8_t>& volume, const std::filesystem::path& path);
void writeVolume(const AnyVolume& volume, const std::filesystem::path& path);

}  // namespace angiomesh

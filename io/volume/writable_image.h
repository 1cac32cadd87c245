// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "core/image/volume.h"
#include "io/volume/any_volume.h"

namespace angiomesh {

/// What is written: the voxels as bytes, with all that a header tells.
struct WritableImage {
  const Geometry& geometry;
  VoxelType type;
  std::span<const std::byte> bytes;
};

/// What writeVolume() does with a name that ends in this.
void writeMha(const WritableImage& image, const std::filesystem::path& path);
void writeMhd(const WritableImage& image, const std::filesystem::path& path);
void writeNrrd(const WritableImage& image, const std::filesystem::path& path);
void writeNhdr(const WritableImage& image, const std::filesystem::path& path);
void writeNii(const WritableImage& image, const std::filesystem::path& path);
void writeNiiGz(const WritableImage& image, const std::filesystem::path& path);

}  // namespace angiomesh

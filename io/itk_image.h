// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/image/volume.h"
#include "io/image_format.h"
#include "io/image_io.h"

namespace angiomesh {

/// Geometry and pixel type from the header, and the voxels as float. @throws IoError, InputError
ImageSummary itkDescribe(const std::filesystem::path& path, ImageFormat format);
LoadedImage itkRead(const std::filesystem::path& path, ImageFormat format);

/// The stored values of all frames of one DICOM file, in file order, for the transfer syntaxes that
/// DCMTK does not decode. `count` pixels are expected. @throws IoError, InputError
std::vector<float> itkReadDicomPixels(const std::filesystem::path& path, std::size_t count);

/// Writes by extension, compressed where the format can. Not atomic. @throws IoError, InputError
void itkWrite(const Volume<float>& volume, const std::filesystem::path& path);
void itkWrite(const Volume<std::uint8_t>& volume, const std::filesystem::path& path);

}  // namespace angiomesh

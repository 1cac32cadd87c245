// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/image/volume.h"
#include "io/image_format.h"

namespace angiomesh {

/// The geometry of a MetaImage or NRRD file, from its header; that of space where the image has
/// more axes. @throws IoError, InputError
Geometry itkGeometry(const std::filesystem::path& path, ImageFormat format);

/// All values of an image that is written as text, `bytesPerValue` each, in this machine's order.
/// @throws IoError, InputError
std::vector<char> itkReadText(const std::filesystem::path& path, ImageFormat format,
                              std::size_t bytesPerValue);

/// The stored values of all frames of one DICOM file, in file order, for the transfer syntaxes that
/// DCMTK does not decode. `count` pixels are expected; errors name the file `named`.
/// @throws IoError, InputError
std::vector<float> itkReadDicomPixels(const std::filesystem::path& path,
                                      const std::filesystem::path& named, std::size_t count);

}  // namespace angiomesh

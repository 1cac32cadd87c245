// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace angiomesh {

/// The stored values of all frames of one DICOM file, in file order, for the transfer syntaxes that
/// DCMTK does not decode. `count` pixels are expected; errors name the file `named`.
/// @throws IoError, InputError
std::vector<float> itkReadDicomPixels(const std::filesystem::path& path,
                                      const std::filesystem::path& named, std::size_t count);

}  // namespace angiomesh

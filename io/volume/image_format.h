// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace angiomesh {

enum class ImageFormat { MetaImage, Nrrd, Nifti, Dicom };

/// The format by content, whatever the name says. @throws IoError (missing, unreadable, empty),
/// InputError (not an image that Angiomesh reads)
ImageFormat imageFormat(const std::filesystem::path& path);

/// True when the first bytes are those of a DICOM file. @throws IoError (the file cannot be opened
/// or read, which says nothing of what it is)
bool looksLikeDicom(const std::filesystem::path& path);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace angiomesh {

enum class ImageFormat { MetaImage, Nrrd, Nifti, Dicom };

/// The format by content, whatever the name says. @throws IoError (missing, unreadable, empty),
/// InputError (not an image that Angiomesh reads)
ImageFormat imageFormat(const std::filesystem::path& path);

/// True when the first bytes are those of a DICOM file; never throws for a file that is none.
bool looksLikeDicom(const std::filesystem::path& path);

/// What a header says beside the geometry.
struct HeaderFacts {
  std::string modality;               ///< "MR", "CT", "" when not stated
  std::vector<std::string> warnings;  ///< without the file's name
};

/// Reads the header of a MetaImage, NRRD or NIfTI file with as much care as it takes to know how
/// many bytes of voxels have to follow, and counts them (`countVoxels`): ITK fills up a truncated
/// MetaImage or NIfTI file without a word.
/// @throws IoError (truncated, damaged), InputError (a header that makes no sense)
HeaderFacts checkHeader(const std::filesystem::path& path, ImageFormat format, bool countVoxels);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// What `info` says of an input, beside the volume. Nothing here identifies a patient.
struct InputInfo {
  std::string format;     ///< "MetaImage", "NRRD", "NIfTI", "DICOM"
  std::string modality;   ///< "MR", "CT", "" when the file does not say
  std::string pixelType;  ///< "int16" ...
  std::string seriesUid;  ///< DICOM only
  std::string seriesDescription;
  int files = 1;
  std::optional<double> window, level;  ///< from the file
  std::vector<std::string> warnings;
};

struct LoadedImage {
  Volume<float> image;
  InputInfo info;
};

/// Reads .mha/.mhd, .nrrd/.nhdr, .nii/.nii.gz (any pixel type, any direction; NIfTI turned to LPS),
/// one DICOM file, or a folder that holds one DICOM series (`seriesUid` chooses among several).
/// Checked by checkUsable().
/// @throws IoError (missing, unreadable, truncated), InputError (not 3D, not an image, constant,
/// NaN, several series)
LoadedImage readImage(const std::filesystem::path& path, const std::string& seriesUid = {},
                      const Progress& progress = {});

/// As readImage() but without checkUsable(), for masks: a mask may be constant.
Volume<std::uint8_t> readMask(const std::filesystem::path& path);

/// Geometry, format and pixel type from the headers, for `info`; DICOM folders give one entry per
/// series.
struct ImageSummary {
  Geometry geometry;
  InputInfo info;
};
std::vector<ImageSummary> describeImages(const std::filesystem::path& path);

/// Writes by extension (.mha, .nrrd, .nii, .nii.gz; compressed) to a temporary name, then renames.
/// @throws IoError (no such folder, no permission, disk full): nothing is left behind
void writeVolume(const Volume<float>& volume, const std::filesystem::path& path);
void writeVolume(const Volume<std::uint8_t>& volume, const std::filesystem::path& path);

}  // namespace angiomesh

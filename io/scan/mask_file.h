// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/image/volume.h"
#include "io/dicom/dicom_identity.h"
#include "io/dicom/dicom_seg_write.h"

namespace angiomesh {

/// Writes a mask by extension, as writeVolume() does, and reads it back: a file appears only where
/// it holds the same voxels on the same grid. @throws InputError, IoError: nothing is left behind
void writeMask(const Volume<std::uint8_t>& mask, const std::filesystem::path& path);

/// The DICOM series that a mask is of.
struct DicomOrigin {
  std::filesystem::path path;  ///< a file, or a folder in or below which the series lies
  std::string series;          ///< as ReadOptions::series
  DicomIdentity identity = DicomIdentity::None;
};

/// Of the first file of the series. @throws InputError, IoError
DicomIdentityTexts readIdentity(const DicomOrigin& origin);

/// The same as a DICOM segmentation, see writeSegmentation().
void writeMask(const Volume<std::uint8_t>& mask, const DicomOrigin& origin,
               const std::filesystem::path& path);

}  // namespace angiomesh

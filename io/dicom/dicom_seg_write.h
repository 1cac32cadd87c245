// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/image/volume.h"
#include "io/dicom/dicom_series.h"

namespace angiomesh {

/// Whether a DICOM file that is written names the patient and the study of its source.
enum class DicomIdentity { None, OfSource };

/// Writes a binary DICOM segmentation (SEG, PS3.3 A.51) with one segment, "Blood vessel", and a
/// frame for each slice of the mask. It has the frame of reference of the series it is of, and
/// refers to its images. Without the identity, patient and study are empty, with a new UID of the
/// study; what else has a UID of its own gets a new one in either case. The file appears as a
/// whole.
/// @param mask on the grid of the series, or between its slices, as readDicomStack() makes it
/// @throws InputError (another grid), IoError
void writeSegmentation(const Volume<std::uint8_t>& mask, const DicomStack& series,
                       DicomIdentity identity, const std::filesystem::path& path);

}  // namespace angiomesh

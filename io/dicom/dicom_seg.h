// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "io/dicom/dicom_series.h"
#include "io/volume/any_volume.h"
#include "io/volume/loaded_image.h"

namespace angiomesh {

/// A DICOM segmentation (SEG, PS3.3 A.51): segments that may overlap, of which each has frames
/// where it has voxels.
struct DicomSegmentation {
  DicomStack stack;  ///< all frames, as they stand in the file
  Geometry geometry;
  InputInfo info;
  std::vector<Label> segments;  ///< value: the number of the segment; layer: its place here
  bool fractional = false;
};

/// Nothing where the path is no DICOM file, or another one. @throws IoError, InputError (no frames,
/// or frames that form no grid)
std::optional<DicomSegmentation> openSegmentation(const std::filesystem::path& path);

/// The voxels of one segment: its number or 0, or, of a fractional one, 0 to 1 in float32.
/// @throws IoError, InputError
AnyVolume readSegment(const DicomSegmentation& segmentation, std::size_t segment,
                      const Progress& progress);

/// All segments in one image of their numbers. @throws IoError, InputError (they overlap or are
/// fractional; `path` is named)
AnyVolume readSegments(const DicomSegmentation& segmentation, const std::filesystem::path& path,
                       const Progress& progress);

}  // namespace angiomesh

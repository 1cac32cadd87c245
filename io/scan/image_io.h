// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "io/volume/any_volume.h"
#include "io/volume/loaded_image.h"

namespace angiomesh {

/// Reads .mha/.mhd, .nrrd/.nhdr, .nii/.nii.gz (any pixel type, any direction; NIfTI turned to LPS),
/// one DICOM file, or a folder in or below which a DICOM series lies (`series` chooses among
/// several). What the header claims is compared with the sizes of the files and with the memory of
/// the machine before anything is allocated. Checked by checkUsable().
/// @throws IoError (missing, unreadable, truncated), InputError (not 3D, not an image, constant,
/// NaN, several series, more than the memory), UnevenSlicesError
LoadedImage readImage(const std::filesystem::path& path, const ReadOptions& options = {},
                      const Progress& progress = {});

struct MaskImage {
  Volume<std::uint8_t> mask;  ///< 1 inside
  std::vector<std::string> warnings;
};

/// As readImage() but without checkUsable(), for masks: a mask may be constant. 1 where not 0, once
/// makeLabels() has seen to values that are no whole numbers, or where the threshold is reached.
MaskImage readMask(const std::filesystem::path& path, std::optional<double> threshold = {});

struct NativeImage {
  AnyVolume volume;
  InputInfo info;
};

/// The voxels in the type of the file, bit for bit. Rescaled ones (DICOM, NIfTI's scl_slope) in the
/// narrowest of int16, uint16, float32 and float64 that holds them exactly. `component` takes one
/// of several values per voxel or one of several points in time, from 0 on. Not checked by
/// checkUsable(). @throws as readImage()
NativeImage readNative(const std::filesystem::path& path, const ReadOptions& options = {},
                       std::optional<int> component = {}, const Progress& progress = {});

/// One entry from the headers; DICOM folders give one per series.
std::vector<ImageSummary> describeImages(const std::filesystem::path& path,
                                         const Progress& progress = {},
                                         ScanDepth depth = ScanDepth::AllBelow);

/// Reads an entry of a DICOM folder without looking through the folder again, or a scan in another
/// format. Voxels that are no finite numbers are replaced.
/// @throws as readImage()
LoadedImage readImage(const ImageSummary& entry, const std::filesystem::path& path, bool evenOut,
                      const Progress& progress = {});

}  // namespace angiomesh

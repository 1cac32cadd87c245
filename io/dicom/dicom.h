// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/projection.h"
#include "io/volume/loaded_image.h"

namespace angiomesh {

/// One series out of a folder and all below it, or one file. `options.series` may be empty when
/// only one series makes a volume. @throws IoError, InputError, UnevenSlicesError, Cancelled
LoadedImage readDicom(const std::filesystem::path& path, const ReadOptions& options,
                      const Progress& progress);

/// The series that readDicom() would read, by its headers alone. `warnings` are added to.
/// @throws IoError, InputError, Cancelled
std::shared_ptr<const DicomStack> findDicom(const std::filesystem::path& path,
                                            const std::string& series, const Progress& progress,
                                            std::vector<std::string>& warnings);

/// A volume that describeDicom() listed. @throws as readDicom()
LoadedImage readDicomStack(const std::shared_ptr<const DicomStack>& stack, bool evenOut,
                           const std::filesystem::path& path, const Progress& progress);

/// One entry per series, or per volume where a series holds several, by series UID.
std::vector<ImageSummary> describeDicom(const std::filesystem::path& path, const Progress& progress,
                                        ScanDepth depth);

/// The entry that is meant when none is chosen: the only one, or the only one of three slices and
/// more with a position, so that localizers and single pictures do not stand in the way.
std::optional<std::size_t> loneVolume(const std::vector<ImageSummary>& entries);

/// That others were left out beside a loneVolume(); "" where there were none.
std::string leftOutText(const std::vector<ImageSummary>& entries);

/// True when `wanted` is the end of a volume's id, or of the UID of its series.
bool fitsSeries(const std::string& id, const std::string& wanted);

/// The middle slice of a DICOM entry, in the window of the file or the 1st to the 99.8th
/// percentile, pixels square, the longer side `size` pixels. Empty when it cannot be read.
Picture thumbnail(const ImageSummary& entry, int size);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/image_io.h"

namespace angiomesh {

/// One series out of a folder and all below it, or one file. `options.series` may be empty when
/// only one series makes a volume. @throws IoError, InputError, UnevenSlicesError, Cancelled
LoadedImage readDicom(const std::filesystem::path& path, const ReadOptions& options,
                      const Progress& progress);

/// A volume that describeDicom() listed. @throws as readDicom()
LoadedImage readDicomStack(const std::shared_ptr<const DicomStack>& stack, bool evenOut,
                           const std::filesystem::path& path, const Progress& progress);

/// One entry per series, or per volume where a series holds several, by series UID.
std::vector<ImageSummary> describeDicom(const std::filesystem::path& path, const Progress& progress,
                                        ScanDepth depth);

}  // namespace angiomesh

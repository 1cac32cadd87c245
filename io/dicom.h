// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/image_io.h"

namespace angiomesh {

/// One series out of a folder, or one file. `seriesUid` may be empty when there is only one series.
/// @throws IoError, InputError, Cancelled
LoadedImage readDicom(const std::filesystem::path& path, const std::string& seriesUid,
                      const Progress& progress);

/// One entry per series, by series UID.
std::vector<ImageSummary> describeDicom(const std::filesystem::path& path);

}  // namespace angiomesh

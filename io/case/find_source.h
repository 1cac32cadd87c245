// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/pipeline/pipeline.h"
#include "io/case/case_file.h"
#include "io/scan/image_io.h"

namespace angiomesh {

struct FoundSource {
  std::filesystem::path path;
  LoadedImage loaded;
  std::string hash;  ///< contentHash() of it, equal to CaseSource::hash
};

/// The volume at `path`, a file or a folder with one or more series, if it is the one that
/// `source` describes: its headers are compared before its voxels are read.
/// @throws IoError, InputError (no image), Cancelled
std::optional<FoundSource> sourceAt(const std::filesystem::path& path, const CaseSource& source,
                                    const Progress& progress = {},
                                    ScanDepth depth = ScanDepth::AllBelow);

/// The same for many places, the first that fits; places that hold no image are passed over.
std::optional<FoundSource> findSource(const std::vector<std::filesystem::path>& places,
                                      const CaseSource& source, const Progress& progress = {});

/// Where the source of a case at `folder` may lie: the entries of the folder that it lies in, that
/// folder itself, and the same one level up. At most some hundreds.
std::vector<std::filesystem::path> placesNear(const std::filesystem::path& folder);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// The result of the step evolve as a case's folder cache/ keeps it; the folder may be deleted at
/// any time.
struct CachedEvolve {
  EvolveResult result;
  StageReport report;  ///< its key says what the result is of
};

/// Writes the result, unless the cache holds it already. @throws IoError: no other result is taken
/// for this one
void writeCache(const std::filesystem::path& folder, const CachedEvolve& evolve);

/// The result with this key, if it is there and whole. Never throws.
std::optional<CachedEvolve> readCache(const std::filesystem::path& folder, const std::string& key);

}  // namespace angiomesh

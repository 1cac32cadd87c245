// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace angiomesh {

/// Hash of a volume and where it was seen last, the latest first. Lives in the user's settings:
/// paths may tell a patient's name, so no case holds one.
using KnownSources = std::vector<std::pair<std::string, std::filesystem::path>>;

/// The folder of the settings becomes readable by the user alone, for their paths.
void keepSettingsPrivate();

KnownSources knownSources();
void rememberSource(const std::string& hash, const std::filesystem::path& path);

/// Those with this hash.
std::vector<std::filesystem::path> placesOf(const std::string& hash, const KnownSources& known);

}  // namespace angiomesh

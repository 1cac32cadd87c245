// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/image/projection.h"

namespace angiomesh {

/// What to do about a damaged file.
inline constexpr const char* kCopyAgain = "copy or download it again";

/// The folder that a file lies in; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// @throws IoError unless a regular file can come to stand at `target`
void checkTarget(const std::filesystem::path& target);

/// Calls `write` with a temporary name beside `path` (same extension), then renames it to `path`;
/// removes it when `write` throws or when the medium is full. Before the first file in a folder,
/// what killed programs left there goes (see removeLeftovers()). @throws IoError that says what
/// cannot be written, where and what to do
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

void writeText(const std::filesystem::path& path, std::string_view text);

/// What a JSON file of ours holds at most.
inline constexpr std::uintmax_t kMostJsonBytes = std::uintmax_t{64} << 20;
/// The bytes of a regular file. @throws IoError, also when there are more than `most`
std::string readText(const std::filesystem::path& path, std::uintmax_t most = ~std::uintmax_t{0});

/// PNG, without a display.
void writePng(const Picture& picture, const std::filesystem::path& path);

}  // namespace angiomesh

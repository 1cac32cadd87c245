// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/image/projection.h"

namespace angiomesh {

/// What to do about a damaged file.
inline constexpr const char* kCopyAgain = "copy or download it again";

/// Calls `write` with a temporary name beside `path` (same extension), then renames it to `path`;
/// removes it when `write` throws or when the medium is full. @throws IoError that says what cannot
/// be written, where and what to do
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

void writeText(const std::filesystem::path& path, std::string_view text);
std::string readText(const std::filesystem::path& path);

/// PNG, without a display.
void writePng(const Picture& picture, const std::filesystem::path& path);

}  // namespace angiomesh

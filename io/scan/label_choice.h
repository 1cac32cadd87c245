// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/scan/label_image.h"

namespace angiomesh {

/// Those of `labels` that a text names: a value, a name, or several between commas; "value:7",
/// "name:7" and "id:Segment_1" say which of these is meant. Empty: the only one.
/// @throws InputError (no such label, one that fits several, several and none chosen), which lists
/// the labels
std::vector<Label> chosenLabels(const std::vector<Label>& labels, const std::string& choice,
                                const std::filesystem::path& path);

}  // namespace angiomesh

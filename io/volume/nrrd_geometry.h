// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// The fields of an NRRD header by their names in small letters, without those of other programs.
using NrrdFields = std::map<std::string, std::string>;

/// The words of a field: between blanks, or in quotes.
std::vector<std::string> nrrdWords(const std::string& text);

/// "(1,0,0) none (0,0,2)": a vector for each axis, nothing for those that have none. @throws
/// InputError naming `field`
std::vector<std::optional<std::vector<double>>> nrrdVectors(const std::string& text,
                                                            const std::string& field,
                                                            const std::filesystem::path& path);

/// Where the image lies, in LPS and mm. `axes`: those of the file's axes that are of space, three
/// of them, and `sizes` theirs. What is not known for certain is said in `warnings`.
/// @throws InputError (a space, a unit, a number or a direction that makes no sense)
Geometry nrrdGeometry(const NrrdFields& fields, const std::vector<std::size_t>& axes,
                      const std::vector<std::uintmax_t>& sizes, const std::filesystem::path& path,
                      std::vector<std::string>& warnings);

}  // namespace angiomesh

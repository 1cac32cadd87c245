// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/mesh_io.h"

namespace angiomesh::cli {

/// "lps" or "ras", "mm" or "m", as the parser has checked them.
Frame frameFromOption(const std::string& word);
LengthUnit unitFromOption(const std::string& word);

/// Of the two words; empty: by the file's header.
MeshReadOptions meshReadOptions(const std::string& frame, const std::string& unit);

}  // namespace angiomesh::cli

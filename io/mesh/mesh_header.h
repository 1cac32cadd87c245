// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_io.h"

namespace angiomesh {

/// The words SPACE=LPS, UNIT=mm and KEY=... of a mesh file's header or comments; SPACE is the one
/// that 3D Slicer writes and reads.
struct MeshHeader {
  std::optional<Frame> frame;
  std::optional<LengthUnit> unit;
  std::string key;
  std::string contradiction;         ///< "SPACE=LPS and SPACE=RAS", empty: none
  std::vector<std::string> unknown;  ///< such as "UNIT=cm"

  /// Takes the words out of one line.
  void read(std::string_view text);
};

/// "SPACE=LPS UNIT=mm", and the key after another `separator` where there is one.
std::string headerWords(const MeshWriteOptions& options, const std::string& separator);

/// One word of printable ASCII, without '=', out of any text.
std::string cleanKey(const std::string& key);

}  // namespace angiomesh

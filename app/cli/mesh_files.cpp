// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/mesh_input.h"

namespace angiomesh::cli {

Frame frameFromOption(const std::string& word) { return word == "ras" ? Frame::Ras : Frame::Lps; }

LengthUnit unitFromOption(const std::string& word) {
  return word == "m" ? LengthUnit::Metre : LengthUnit::Millimetre;
}

MeshReadOptions meshReadOptions(const std::string& frame, const std::string& unit) {
  MeshReadOptions options;
  if (!frame.empty()) options.frame = frameFromOption(frame);
  if (!unit.empty()) options.unit = unitFromOption(unit);
  return options;
}

}  // namespace angiomesh::cli

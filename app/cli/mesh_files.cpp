// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/mesh_files.h"

#include "app/cli/session.h"

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

void writeChecked(const TriMesh& mesh, const std::filesystem::path& place, const std::string& name,
                  const MeshWriteOptions& options) {
  for (const std::string& warning : writeMesh(mesh, place, options))
    printWarning(warning + ", " + name);
  checkMeshFile(mesh, place, options);
}

}  // namespace angiomesh::cli

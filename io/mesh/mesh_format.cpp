// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_format.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "io/file/files.h"
#include "io/mesh/mesh_place.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoTopology =
    "STL keeps no topology: each triangle stands by itself, and its points have to be merged again "
    "on import.";

void writePlyFile(const WritableMesh& mesh, const fs::path& path) {
  writeText(path, plyBytes(mesh));
}

void writeStlFile(const WritableMesh& mesh, const fs::path& path) {
  writeText(path, mesh.options.encoding == MeshEncoding::Ascii ? stlText(mesh) : stlBytes(mesh));
}

void writeObjFile(const WritableMesh& mesh, const fs::path& path) {
  writeText(path, objBytes(mesh));
}

void writeOffFile(const WritableMesh& mesh, const fs::path& path) {
  writeText(path, offBytes(mesh));
}

void writeVtpFile(const WritableMesh& mesh, const fs::path& path) {
  writeAtomically(path, [&](const fs::path& temporary) {
    try {
      writeVtp(mesh, temporary);
    } catch (const IoError&) {
      throw IoError("cannot write the mesh", path.string(),
                    "check that the folder may be written to and has free space");
    }
  });
}

}  // namespace

const std::vector<MeshFormat>& meshFormats() {
  static const std::vector<MeshFormat> formats{
      {".ply", "PLY", true, true, true, PatchNames::Always, false, "", readPly, writePlyFile},
      {".stl", "STL", true, true, false, PatchNames::InText, true, kNoTopology, readStl,
       writeStlFile},
      {".obj", "OBJ", false, true, false, PatchNames::InText, false, "", readObj, writeObjFile},
      {".off", "OFF", false, true, false, PatchNames::Never, false, "", readOff, writeOffFile},
      {".vtp", "VTP (VTK)", true, false, true, PatchNames::Always, false, "", readVtkPolyData,
       writeVtpFile},
      {".vtk", "VTK", false, false, false, PatchNames::Always, false, "", readVtkPolyData, nullptr},
  };
  return formats;
}

const MeshFormat* meshFormatOf(const fs::path& path) {
  const std::string extension = meshExtension(path);
  const auto& all = meshFormats();
  const auto found = std::find_if(all.begin(), all.end(), [&](const MeshFormat& format) {
    return extension == format.extension;
  });
  return found != all.end() ? &*found : nullptr;
}

std::string meshEndings(bool onlyWritten) {
  std::vector<std::string> endings;
  for (const MeshFormat& format : meshFormats())
    if (format.written() || !onlyWritten) endings.emplace_back(format.extension);
  return eitherOf(endings);
}

}  // namespace angiomesh

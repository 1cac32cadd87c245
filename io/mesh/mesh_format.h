// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh/polygon_mesh.h"

namespace angiomesh {

/// Where a format can hold what patches are called.
enum class PatchNames { Never, InText, Always };

/// A file format of meshes. All that lists formats (reading, writing, options, the desktop's export
/// dialog, help and messages) comes from their table.
struct MeshFormat {
  const char* extension;  ///< ".ply"
  const char* name;
  bool binary, text;  ///< the encodings that are written; neither: it is only read
  bool properties;    ///< normals and quality can be written
  PatchNames names;
  bool singlePrecision;  ///< of what is binary
  const char* hint;      ///< for who exports; English, to be translated; may be empty
  /// @throws IoError (truncated), InputError (not such a file)
  PolygonMesh (*read)(const std::string& bytes, const std::filesystem::path& path);
  /// To a temporary name, then renamed; null of what is only read. @throws IoError
  void (*write)(const WritableMesh& mesh, const std::filesystem::path& path);

  [[nodiscard]] bool written() const { return write != nullptr; }
  [[nodiscard]] bool holdsNames(MeshEncoding encoding) const {
    return names == PatchNames::Always ||
           (names == PatchNames::InText && text && (encoding == MeshEncoding::Ascii || !binary));
  }
};

const std::vector<MeshFormat>& meshFormats();

/// By the ending of the name; null: none has it.
const MeshFormat* meshFormatOf(const std::filesystem::path& path);

/// ".ply, .stl, .obj or .vtp": of the formats that are written, or of all.
std::string meshEndings(bool onlyWritten);

}  // namespace angiomesh

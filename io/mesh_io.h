// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/surface/tri_mesh.h"

namespace angiomesh {

enum class LengthUnit { Millimetre, Metre };
enum class Frame { Lps, Ras };

struct MeshWriteOptions {
  LengthUnit unit = LengthUnit::Millimetre;
  Frame frame = Frame::Lps;
  std::string key;  ///< pipeline key, written into the header comment where the format has one
};

/// Writes binary .ply (float64 vertices), binary .stl, .obj or .vtp by extension, to a temporary
/// name, then renames. Unit and frame are stated in the header. Faces keep their outward
/// orientation in either frame.
/// @throws IoError; nothing is left behind
void writeMesh(const TriMesh& mesh, const std::filesystem::path& path,
               const MeshWriteOptions& options = {});

/// Reads .ply, .stl, .obj, .vtp or legacy .vtk; points equal bit for bit are merged (STL), polygons
/// are triangulated. LPS mm unless the header states otherwise (then converted). @throws IoError,
/// InputError
TriMesh readMesh(const std::filesystem::path& path);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "io/mesh/mesh_header.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh {

/// What a mesh file holds, before triangulation and in the file's own frame and unit.
struct PolygonMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::uint32_t> groups;    ///< of polygons; empty: none
  std::vector<std::string> groupNames;  ///< in the order of the file; empty: has none
  MeshHeader header;
  bool hasNormals = false, hasQuality = false;
  bool oddGroups = false;            ///< were stated in a way that makes no sense, and left out
  std::vector<std::string> remarks;  ///< warnings of the reader, without the file's name
};

/// A remark on bytes that come after all that a header tells of: a second mesh, most likely.
inline std::string leftBytes(std::size_t bytes) {
  return "the file holds " + std::to_string(bytes) +
         " bytes after what its header tells of, which are left out: several meshes in one file "
         "are "
         "not read";
}

/// @throws IoError (truncated), InputError (not such a file)
PolygonMesh readPly(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readStl(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readObj(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readOff(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readLegacyVtk(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readVtp(const std::string& bytes, const std::filesystem::path& path);
/// .vtp and legacy .vtk, by content.
PolygonMesh readVtkPolyData(const std::string& bytes, const std::filesystem::path& path);

/// The triangles of a strip, each second one turned round.
void appendStrip(const std::vector<std::uint32_t>& strip,
                 std::vector<std::vector<std::uint32_t>>& polygons);

/// Polygons as triangles, n - 2 for n corners. Those that cannot be cut without triangles over each
/// other, as they cross themselves, are `folded`.
struct CutPolygons {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t folded = 0;
};

/// Indices must be in range.
CutPolygons triangulate(const PolygonMesh& mesh);

/// A mesh in the frame and unit of the options, with what they ask for.
struct WritableMesh {
  TriMesh mesh;
  std::vector<Eigen::Vector3d> normals;  ///< of vertices; empty: not wanted
  std::vector<double> quality;           ///< of triangles; empty: not wanted
  std::vector<std::string> patchNames;   ///< see patchNamesFor()
  const MeshWriteOptions& options;
};

std::string plyBytes(const WritableMesh& mesh);
std::string stlText(const WritableMesh& mesh);
std::string stlBytes(const WritableMesh& mesh);
std::string objBytes(const WritableMesh& mesh);
std::string offBytes(const WritableMesh& mesh);
/// Not atomic. @throws IoError
void writeVtp(const WritableMesh& mesh, const std::filesystem::path& path);

}  // namespace angiomesh

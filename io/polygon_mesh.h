// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/surface/tri_mesh.h"
#include "io/mesh_io.h"

namespace angiomesh {

/// What a mesh file holds, before triangulation and in the file's own frame and unit.
struct PolygonMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  Frame frame = Frame::Lps;
  LengthUnit unit = LengthUnit::Millimetre;
};

/// Takes "SPACE=RAS" and "UNIT=m" out of a header or comment; SPACE is the word that 3D Slicer
/// writes and reads.
void readFrameAndUnit(const std::string& text, PolygonMesh& mesh);
std::string frameWord(Frame frame);
std::string unitWord(LengthUnit unit);

/// @throws IoError (truncated), InputError (not such a file)
PolygonMesh readPly(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readStl(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readObj(const std::string& bytes, const std::filesystem::path& path);
PolygonMesh readLegacyVtk(const std::string& bytes, const std::filesystem::path& path);
/// .vtp and legacy .vtk, by content.
PolygonMesh readVtkPolyData(const std::string& bytes, const std::filesystem::path& path);

/// Cuts polygons with more than three corners into triangles. Indices must be in range.
std::vector<std::array<std::uint32_t, 3>> triangulate(const PolygonMesh& mesh);

/// `mesh` already in the frame and unit of the options. Not atomic. @throws IoError
void writeVtp(const TriMesh& mesh, const std::filesystem::path& path,
              const MeshWriteOptions& options);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace angiomesh {

enum class LengthUnit { Millimetre, Metre };
enum class Frame { Lps, Ras };
enum class MeshEncoding { Binary, Ascii };

/// "LPS" and "RAS", "mm" and "m": the words of the files' headers.
std::string frameWord(Frame frame);
std::string unitWord(LengthUnit unit);

struct MeshWriteOptions {
  LengthUnit unit = LengthUnit::Millimetre;
  Frame frame = Frame::Lps;
  std::string key = {};                          ///< pipeline key, written into the header comment
  MeshEncoding encoding = MeshEncoding::Binary;  ///< of PLY and STL; OBJ is always text
  bool normals = false;  ///< PLY and VTP: unit normals of the vertices, 0 where no triangle is
  bool quality = false;  ///< PLY and VTP: `quality` of each face, 2 * inradius / circumradius
  /// VTP: arrays of the vertices by their names, one value each.
  std::vector<std::pair<std::string, std::vector<float>>> pointValues = {};
  /// Of TriMesh::patch: the wall's, then the ports' in their order. One that is not given is "wall"
  /// or "patch_n". In names, what is no printable ASCII becomes '_'; the same name again gets a
  /// number. Of a mesh without patches the first names the solid of an ASCII STL file ("surface").
  std::vector<std::string> patchNames = {};
};

/// @throws InputError unless the name ends as a mesh that can be written
void checkMeshName(const std::filesystem::path& path);

/// Writes .ply (float64 vertices), .stl, .obj or .vtp by extension, to a temporary name, then
/// renames. Frame and unit are stated in the header, the frame as 3D Slicer reads it. Text holds
/// the shortest numbers that read back as the same double (ASCII STL: at least 9 digits), so that
/// equal points stay equal and others do not. Closed parts that face inward are turned round in the
/// file, see turnOutward().
///
/// Patches are the solids of ASCII STL and the groups (g) of OBJ, triangles in their order; `patch`
/// of each face and lines "comment patch 1 inlet" of PLY; and, as in SimVascular, `ModelFaceID` of
/// each cell (1 + patch) with the names in the field `ModelFaceNames` of VTP. Binary STL has none.
/// @returns warnings: parts that were turned round; patches that a binary STL file loses; triangles
/// that lose their area, and points that fall together, in its single precision (it is written
/// nevertheless)
/// @throws InputError: the mesh is not usable, an option that the format does not have
/// @throws IoError; nothing is left behind
std::vector<std::string> writeMesh(const TriMesh& mesh, const std::filesystem::path& path,
                                   const MeshWriteOptions& options = {});

/// What the user knows better than the file.
struct MeshReadOptions {
  std::optional<Frame> frame;
  std::optional<LengthUnit> unit;
  /// Points at one place that the file has apart stay apart (PLY, OBJ, VTK; STL has no others).
  bool keepPoints = false;
  /// Triangles of a part that are not oriented alike stay so.
  bool keepTurns = false;
  /// Of points at open edges, which become one within so much of each other; 0: none do.
  double mergeDistanceMm = 0.0;
};

struct LoadedMesh {
  TriMesh mesh;                                  ///< LPS, mm, closed parts facing outward
  Frame frame = Frame::Lps;                      ///< of the file
  LengthUnit unit = LengthUnit::Millimetre;      ///< of the file
  bool frameStated = false, unitStated = false;  ///< in its header
  std::string key;                               ///< of the pipeline, empty: none stated
  bool hasNormals = false, hasQuality = false;
  /// Of mesh.patch. Of a mesh without patches: what the file calls its only solid, group or face;
  /// empty: nothing.
  std::vector<std::string> patchNames;
  std::size_t turnedParts = 0;  ///< closed parts that faced inward
  std::vector<std::string> warnings;
};

/// Reads .ply, .stl, .obj, .vtp or legacy .vtk. Points equal bit for bit are merged, in formats
/// other than STL with a warning and not in a mesh that is closed as it is. Polygons are cut into
/// triangles. Triangles that are not oriented as most of their part are turned round, and then
/// closed parts that face inward, each with a warning. LPS and mm unless the header or `options`
/// say otherwise; a size that no vessel has is a warning.
///
/// Patches are read where writeMesh() writes them, `o` of an OBJ file without `g` included, and
/// from legacy VTK files, too; `CellEntityIds`, as VMTK and Gmsh write them, where there is no
/// `ModelFaceID`. Names are whole lines ("outlet 1"). Patch 0 is the one called "wall", whatever
/// its number in the file; the others are 1, 2, ... in the order of their first solid or group, or
/// of their numbers in PLY and VTK files. Where none is called "wall", no triangle is in patch 0:
/// names stay, numbers move. What has no name is "patch_n" or, in VTK files, "face_ID"; `patch` 0
/// of a PLY file is "wall". Names are cleaned as in writing. A file with one patch alone has none.
/// @throws IoError, InputError
LoadedMesh loadMesh(const std::filesystem::path& path, const MeshReadOptions& options = {});

/// The mesh of loadMesh().
TriMesh readMesh(const std::filesystem::path& path);

/// What a written file holds, as read back.
struct MeshFileFacts {
  std::size_t vertices = 0, triangles = 0;
  bool closed = false;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< of the bounding box, in `unit`
  LengthUnit unit = LengthUnit::Millimetre;
  Frame frame = Frame::Lps;
};

/// Reads again what writeMesh() made of `mesh` and compares: vertices (merged, STL), triangles,
/// bounding box within the numbers' precision, closedness, frame, unit, normals, quality, and
/// names, triangles and shape of the patches.
/// @throws IoError with the figures when the file holds something else
MeshFileFacts checkMeshFile(const TriMesh& mesh, const std::filesystem::path& path,
                            const MeshWriteOptions& options = {});

}  // namespace angiomesh

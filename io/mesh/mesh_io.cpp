// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_io.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/mesh/outward.h"
#include "core/mesh/triangle_shape.h"
#include "io/file/files.h"
#include "io/file/text_scanner.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_merge.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/mesh_place.h"
#include "io/mesh/point_merger.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

std::string counted(std::size_t number, const char* one, const char* many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

/// The format of a name that can be written. @throws InputError
const MeshFormat& writtenFormat(const fs::path& path) {
  const MeshFormat* format = meshFormatOf(path);
  if (format == nullptr || !format->written())
    throw InputError("cannot tell the mesh format from the name", path.string(),
                     "end the name in " + meshEndings(true));
  return *format;
}

/// Refuses what the format does not have.
void checkOptions(const MeshFormat& format, const MeshWriteOptions& options, const fs::path& path) {
  if (options.encoding == MeshEncoding::Ascii && !format.text)
    throw InputError("this format is not written as ASCII text", path.string(),
                     "choose .ply or .stl");
  if ((options.normals || options.quality) && !format.properties)
    throw InputError("normals and quality can be written only to PLY and VTP files", path.string(),
                     "choose .ply or .vtp, or leave them out");
  if (!options.pointValues.empty() && std::string_view(format.extension) != ".vtp")
    throw InputError("values of the vertices can be written only to VTP files", path.string(),
                     "choose .vtp");
}

/// Says what the single precision of a binary STL file does to the mesh.
void checkSinglePrecision(const TriMesh& mesh, const fs::path& path,
                          std::vector<std::string>& warnings) {
  for (const Eigen::Vector3d& p : mesh.points)
    if (p.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max())
      throw InputError("the mesh has coordinates beyond single precision", path.string(),
                       "write .ply, .obj or .vtp");
  std::size_t collapsed = 0;
  const auto area = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                       const Eigen::Vector3d& c) { return (b - a).cross(c - a).norm(); };
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    if (area(inSinglePrecision(a), inSinglePrecision(b), inSinglePrecision(c)) == 0.0 &&
        area(a, b, c) > 0.0)
      ++collapsed;
  }
  std::vector<Eigen::Vector3d> exact, rounded;
  PointMerger exactMerger(exact), roundedMerger(rounded);
  for (const Eigen::Vector3d& p : mesh.points) {
    const Eigen::Vector3d q = inSinglePrecision(p);
    exactMerger.add(p.x(), p.y(), p.z());
    roundedMerger.add(q.x(), q.y(), q.z());
  }
  const std::size_t lost = exact.size() - rounded.size();
  if (collapsed == 0 && lost == 0) return;
  warnings.push_back(counted(collapsed, "triangle loses its area", "triangles lose their area") +
                     " and " + counted(lost, "point falls", "points fall") +
                     " onto another in the single precision of a binary STL file: write an ASCII "
                     "STL, PLY, OBJ or VTP file instead");
}

PolygonMesh readPolygons(const fs::path& path) {
  std::string bytes = readText(path);
  if (bytes.empty()) throw IoError("the file is empty", path.string(), kCopyAgain);
  const MeshFormat* format = meshFormatOf(path);
  if (format == nullptr)
    throw InputError("not a mesh file", path.string(), "give " + meshEndings(false));
  // What begins an STL file may be binary.
  if (format->read != readStl && bytes.starts_with(kByteOrderMark))
    bytes.erase(0, kByteOrderMark.size());
  return format->read(bytes, path);
}

/// Ears are cut in a time that grows with the square of the corners: seconds for this many. Faces
/// of fewer than a hundred corners are not counted.
constexpr double kMostSquaredCorners = 1e8;
constexpr std::size_t kFewCorners = 100;

void checkPolygons(const PolygonMesh& mesh, const fs::path& path) {
  if (mesh.polygons.empty())
    throw InputError("the file holds no faces", path.string(), "give a surface mesh");
  double squares = 0.0;
  for (const auto& polygon : mesh.polygons) {
    if (const auto corners = static_cast<double>(polygon.size()); polygon.size() >= kFewCorners)
      squares += corners * corners;
    if (squares > kMostSquaredCorners)
      throw InputError(
          "faces have too many corners (one has " + std::to_string(polygon.size()) + ")",
          path.string(), "cut them into triangles with another program");
    for (const std::uint32_t corner : polygon)
      if (corner >= mesh.points.size())
        throw InputError("a face names a point that does not exist", path.string(),
                         "write the mesh again with another program");
  }
  for (const Eigen::Vector3d& p : mesh.points)
    if (!p.allFinite())
      throw InputError("the mesh holds coordinates that are not finite numbers", path.string(),
                       "write the mesh again with another program");
}

/// Frame and unit: the user's word, else the header's, else LPS and mm.
void settlePlace(const MeshHeader& header, const MeshReadOptions& options, const fs::path& path,
                 LoadedMesh& loaded) {
  const std::string& two = header.contradiction;
  if (two.starts_with("SPACE") ? !options.frame : !two.empty() && !options.unit)
    throw InputError("the header says both " + two, path.string(),
                     "correct the header, or say which is true");
  loaded.frameStated = header.frame.has_value();
  loaded.unitStated = header.unit.has_value();
  loaded.key = header.key;
  loaded.frame = options.frame.value_or(header.frame.value_or(Frame::Lps));
  loaded.unit = options.unit.value_or(header.unit.value_or(LengthUnit::Millimetre));
  const auto overruled = [&](const std::string& said, const std::string& taken) {
    if (said != taken)
      loaded.warnings.push_back("the header says " + said + ", " + taken + " is taken as asked, " +
                                path.string());
  };
  if (header.frame) overruled(frameWord(*header.frame), frameWord(loaded.frame));
  if (header.unit) overruled(unitWord(*header.unit), unitWord(loaded.unit));
  for (const std::string& statement : header.unknown)
    loaded.warnings.push_back("the header says " + statement +
                              ", which is not known: " + frameWord(loaded.frame) + " and " +
                              unitWord(loaded.unit) + " are taken, " + path.string());
}

void takePatches(const PolygonMesh& polygons, const fs::path& path, LoadedMesh& loaded) {
  std::vector<std::uint32_t> groups;
  for (std::size_t p = 0; p < polygons.groups.size(); ++p)
    groups.insert(groups.end(), polygons.polygons[p].size() - 2, polygons.groups[p]);
  PatchSet set = patchesOfGroups(groups, polygons.groupNames);
  loaded.mesh.patch = std::move(set.patch);
  loaded.patchNames = std::move(set.names);
  if (polygons.oddGroups)
    loaded.warnings.push_back(
        "the patches are no whole numbers, or not one for each face, and are left out, " +
        path.string());
  for (const std::string& remark : polygons.remarks)
    loaded.warnings.push_back(remark + ", " + path.string());
  if (set.renamed > 0)
    loaded.warnings.push_back(
        counted(set.renamed, "patch has", "patches have") +
        " the name of another one, where blanks and signs that no solver takes are '_', and a "
        "number behind it, " +
        path.string());
  if (set.tooMany)
    loaded.warnings.push_back("the file has " + std::to_string(polygons.groupNames.size()) +
                              " patches, which are too many and are left out, " + path.string());
}

/// What is shorter than any vessel was mostly written in metres.
void checkSize(const std::vector<Eigen::Vector3d>& points, const MeshReadOptions& options,
               const fs::path& path, LoadedMesh& loaded) {
  constexpr double kShortestMm = 1.0, kLongestMm = 2000.0;
  if (options.unit) return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  const double longest = box.sizes().maxCoeff();
  if (longest == 0.0 || (longest >= kShortestMm && longest <= kLongestMm)) return;
  loaded.warnings.push_back(
      formatted("the mesh is %.3g mm long", longest) +
      std::string(longest < kShortestMm ? ", shorter than any vessel: are its numbers metres"
                                        : ", longer than any vessel: are its numbers not mm") +
      "? Give its unit when reading (convert --from-unit, quality --unit), " + path.string());
}

void mergePoints(const MeshReadOptions& options, const fs::path& path, LoadedMesh& loaded) {
  // Cracks of rounding are of this share of the whole.
  constexpr double kRounding = 1e-5;
  if (!options.keepPoints)
    if (const std::size_t merged = mergeEqualPoints(loaded.mesh); merged > 0)
      loaded.warnings.push_back(counted(merged, "point that lies", "points that lie") +
                                " at the place of another one became one with it, " +
                                path.string() + ": --keep-points leaves them apart");
  if (options.mergeDistanceMm > 0.0) {
    const OpenMerge merge = mergeOpenPoints(loaded.mesh, options.mergeDistanceMm);
    loaded.warnings.push_back(
        counted(merge.points, "point", "points") + " at open edges became one with another one (" +
        counted(merge.triangles, "triangle", "triangles") + " lost by that), " + path.string());
  } else if (!options.keepPoints && !options.keepTurns) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : loaded.mesh.points) box.extend(p);
    const double share = kRounding * box.diagonal().norm();
    // A round number, to be read and typed.
    const double distance = share > 0.0 ? std::pow(10.0, std::floor(std::log10(share))) : 0.0;
    const std::size_t near = openPointsNear(loaded.mesh, distance);
    const std::string text = formatted("%.1g", distance);
    if (near > 0)
      loaded.warnings.push_back("the surface has cracks: " + counted(near, "point", "points") +
                                " at open edges within " + text + " mm of another one, " +
                                path.string() + ": --merge-distance " + text + " joins them");
  }
}

void turnRound(const MeshReadOptions& options, const fs::path& path, LoadedMesh& loaded) {
  if (!options.keepTurns) {
    const AlikeTurn turn = turnAlike(loaded.mesh);
    if (turn.turned > 0)
      loaded.warnings.push_back(counted(turn.turned, "triangle was", "triangles were") +
                                " not oriented as the others and turned round, " + path.string());
    if (turn.oneSided > 0)
      loaded.warnings.push_back(
          counted(turn.oneSided, "part of the mesh has", "parts of the mesh have") +
          " no inside and no outside, as a Moebius strip, " + path.string() +
          ": make the surface anew");
  }
  loaded.turnedParts = turnOutward(loaded.mesh).turnedParts;
  if (loaded.turnedParts > 0)
    loaded.warnings.push_back(
        counted(loaded.turnedParts, "closed part of the mesh was", "closed parts were") +
        " inside out and turned round, " + path.string());
}

}  // namespace

void checkMeshName(const fs::path& path) { (void)writtenFormat(path); }

std::vector<std::string> writeMesh(const TriMesh& mesh, const fs::path& path,
                                   const MeshWriteOptions& options) {
  const MeshFormat& format = writtenFormat(path);
  checkOptions(format, options, path);
  try {
    checkMesh(mesh);
  } catch (const InputError& error) {
    throw InputError(error.what(), path.string(), "mesh the volume again");
  }
  for (const auto& [name, values] : options.pointValues)
    if (values.size() != mesh.points.size())
      throw InputError("the values " + name + " are not one for each vertex", path.string(),
                       "measure the mesh again");
  std::vector<std::string> warnings;
  WritableMesh moved{mesh, {}, {}, {}, options};
  if (const std::size_t turned = turnOutward(moved.mesh).turnedParts; turned > 0)
    warnings.push_back(counted(turned, "closed part of the mesh was", "closed parts were") +
                       " inside out and turned round in the file");
  toFilePlace(moved.mesh.points, options.frame, options.unit);
  moved.patchNames = patchNamesFor(mesh, options.patchNames);
  if (!format.holdsNames(options.encoding) && moved.patchNames.size() > 1)
    warnings.push_back("the names of " + std::to_string(moved.patchNames.size()) +
                       " patches are lost in a file of this kind: write an ASCII STL, PLY, OBJ or "
                       "VTP file to keep them");
  if (format.singlePrecision && options.encoding == MeshEncoding::Binary)
    checkSinglePrecision(moved.mesh, path, warnings);
  if (options.normals) moved.normals = vertexNormals(moved.mesh);
  if (options.quality) {
    const auto& points = moved.mesh.points;
    for (const auto& t : moved.mesh.triangles)
      moved.quality.push_back(triangleShape(points[t[0]], points[t[1]], points[t[2]]).radiusRatio);
  }
  format.write(moved, path);
  return warnings;
}

LoadedMesh loadMesh(const fs::path& path, const MeshReadOptions& options) {
  PolygonMesh polygons = readPolygons(path);
  checkPolygons(polygons, path);
  LoadedMesh loaded;
  settlePlace(polygons.header, options, path, loaded);
  toPatientPlace(polygons.points, loaded.frame, loaded.unit);
  checkSize(polygons.points, options, path, loaded);
  CutPolygons cut = triangulate(polygons);
  if (cut.folded > 0)
    loaded.warnings.push_back(counted(cut.folded, "face crosses itself", "faces cross themselves") +
                              " and cannot be cut into triangles that do not overlap, " +
                              path.string() + ": write the mesh with triangles only");
  loaded.mesh.triangles = std::move(cut.triangles);
  takePatches(polygons, path, loaded);
  loaded.mesh.points = std::move(polygons.points);
  loaded.hasNormals = polygons.hasNormals;
  loaded.hasQuality = polygons.hasQuality;
  mergePoints(options, path, loaded);
  turnRound(options, path, loaded);
  return loaded;
}

TriMesh readMesh(const fs::path& path) { return loadMesh(path).mesh; }

}  // namespace angiomesh

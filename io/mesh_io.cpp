// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_io.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "io/files.h"
#include "io/polygon_mesh.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<Eigen::Vector3d>;

const char* const kExtensions = "end the name in .ply, .stl, .obj or .vtp";

std::string extensionOf(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// LPS mm to the frame and unit, or back: the turn by 180 degrees about z is its own inverse and
/// keeps the faces' orientation.
void convertPoints(Points& points, Frame frame, double factor) {
  const double flip = frame == Frame::Ras ? -factor : factor;
  for (Eigen::Vector3d& p : points) p = Eigen::Vector3d(flip * p.x(), flip * p.y(), factor * p.z());
}

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// A key goes into one line of a header: anything else than printable ASCII is dropped.
std::string cleanKey(const std::string& key) {
  std::string clean;
  for (const char c : key)
    if (c > ' ' && c < 127) clean += c;
  return clean;
}

std::string plyBytes(const TriMesh& mesh, const MeshWriteOptions& options) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Angiomesh\n";
  bytes += "comment SPACE=" + frameWord(options.frame) + "\n";
  bytes += "comment UNIT=" + unitWord(options.unit) + "\n";
  if (!options.key.empty()) bytes += "comment KEY=" + cleanKey(options.key) + "\n";
  bytes += "element vertex " + std::to_string(mesh.points.size()) + "\n";
  bytes += "property double x\nproperty double y\nproperty double z\n";
  bytes += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  bytes += "property list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + mesh.points.size() * 24 + mesh.triangles.size() * 13);
  for (const Eigen::Vector3d& p : mesh.points)
    for (int a = 0; a < 3; ++a) append(bytes, p[a]);
  for (const auto& triangle : mesh.triangles) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) append(bytes, static_cast<std::int32_t>(corner));
  }
  return bytes;
}

std::string stlBytes(const TriMesh& mesh, const MeshWriteOptions& options) {
  // Readers take a file that begins with "solid" for ASCII.
  std::string bytes =
      "Angiomesh SPACE=" + frameWord(options.frame) + " UNIT=" + unitWord(options.unit);
  if (!options.key.empty()) bytes += " KEY=" + cleanKey(options.key);
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  bytes.reserve(84 + 50 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.points[t[0]];
    const Eigen::Vector3d normal =
        (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).stableNormalized();
    for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(normal[i]));
    for (const std::uint32_t corner : t)
      for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(mesh.points[corner][i]));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string objBytes(const TriMesh& mesh, const MeshWriteOptions& options) {
  std::string bytes = "# Angiomesh\n# SPACE=" + frameWord(options.frame) + "\n";
  bytes += "# UNIT=" + unitWord(options.unit) + "\n";
  if (!options.key.empty()) bytes += "# KEY=" + cleanKey(options.key) + "\n";
  char number[32];
  for (const Eigen::Vector3d& p : mesh.points) {
    bytes += 'v';
    for (int a = 0; a < 3; ++a) {
      // The shortest text that reads back as the same double.
      const auto end = std::to_chars(number, number + sizeof(number), p[a]);
      bytes += ' ';
      bytes.append(number, end.ptr);
    }
    bytes += '\n';
  }
  for (const auto& t : mesh.triangles) {
    bytes += 'f';
    for (const std::uint32_t corner : t) bytes += ' ' + std::to_string(corner + 1);
    bytes += '\n';
  }
  return bytes;
}

}  // namespace

std::string frameWord(Frame frame) { return frame == Frame::Ras ? "RAS" : "LPS"; }

std::string unitWord(LengthUnit unit) { return unit == LengthUnit::Metre ? "m" : "mm"; }

void readFrameAndUnit(const std::string& text, PolygonMesh& mesh) {
  const auto word = [&](const std::string& name) {
    const std::size_t at = text.find(name + "=");
    if (at == std::string::npos) return std::string();
    const std::size_t first = at + name.size() + 1;
    std::size_t last = first;
    while (last < text.size() && std::isalpha(static_cast<unsigned char>(text[last])) != 0) ++last;
    return text.substr(first, last - first);
  };
  if (const std::string frame = word("SPACE"); !frame.empty())
    mesh.frame = frame == "RAS" ? Frame::Ras : Frame::Lps;
  if (const std::string unit = word("UNIT"); !unit.empty())
    mesh.unit = unit == "m" ? LengthUnit::Metre : LengthUnit::Millimetre;
}

void writeMesh(const TriMesh& mesh, const fs::path& path, const MeshWriteOptions& options) {
  const std::string extension = extensionOf(path);
  if (extension != ".ply" && extension != ".stl" && extension != ".obj" && extension != ".vtp")
    throw InputError("cannot tell the mesh format from the name", path.string(), kExtensions);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.points.size())
        throw InputError("a triangle names a point that does not exist", path.string(),
                         "mesh the volume again");
  TriMesh moved = mesh;
  convertPoints(moved.points, options.frame, options.unit == LengthUnit::Metre ? 1e-3 : 1.0);
  if (extension == ".vtp") {
    writeAtomically(path, [&](const fs::path& temporary) {
      try {
        writeVtp(moved, temporary, options);
      } catch (const IoError&) {
        throw IoError("cannot write the mesh", path.string(),
                      "check that the folder may be written to and has free space");
      }
    });
    return;
  }
  if (extension == ".ply")
    writeText(path, plyBytes(moved, options));
  else if (extension == ".stl")
    writeText(path, stlBytes(moved, options));
  else
    writeText(path, objBytes(moved, options));
}

TriMesh readMesh(const fs::path& path) {
  const std::string bytes = readText(path);
  if (bytes.empty()) throw IoError("the file is empty", path.string(), "copy or download it again");
  const std::string extension = extensionOf(path);
  PolygonMesh mesh;
  if (extension == ".ply")
    mesh = readPly(bytes, path);
  else if (extension == ".stl")
    mesh = readStl(bytes, path);
  else if (extension == ".obj")
    mesh = readObj(bytes, path);
  else if (extension == ".vtp" || extension == ".vtk")
    mesh = readVtkPolyData(bytes, path);
  else
    throw InputError("not a mesh file", path.string(), "give .ply, .stl, .obj, .vtp or .vtk");
  if (mesh.polygons.empty())
    throw InputError("the file holds no faces", path.string(), "give a surface mesh");
  for (const auto& polygon : mesh.polygons)
    for (const std::uint32_t corner : polygon)
      if (corner >= mesh.points.size())
        throw InputError("a face names a point that does not exist", path.string(),
                         "write the mesh again with another program");
  for (const Eigen::Vector3d& p : mesh.points)
    if (!p.allFinite())
      throw InputError("the mesh holds coordinates that are not finite numbers", path.string(),
                       "write the mesh again with another program");
  convertPoints(mesh.points, mesh.frame, mesh.unit == LengthUnit::Metre ? 1e3 : 1.0);
  TriMesh result;
  result.triangles = triangulate(mesh);
  result.points = std::move(mesh.points);
  return result;
}

}  // namespace angiomesh

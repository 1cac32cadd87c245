// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstring>

#include "core/base/error.h"
#include "io/files.h"
#include "io/mesh_patch.h"
#include "io/point_merger.h"
#include "io/polygon_mesh.h"
#include "io/text_scanner.h"

namespace angiomesh {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kRecord = 50;

PolygonMesh readBinary(const std::string& bytes, std::uint32_t count) {
  PolygonMesh mesh;
  mesh.header.read(std::string_view(bytes).substr(0, 80));
  PointMerger merger(mesh.points);
  mesh.polygons.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<float, 9> corners{};
    std::memcpy(corners.data(), bytes.data() + kHeader + t * kRecord + 12, sizeof(corners));
    std::vector<std::uint32_t> triangle(3);
    for (std::size_t c = 0; c < 3; ++c)
      triangle[c] = merger.add(corners[3 * c], corners[3 * c + 1], corners[3 * c + 2]);
    mesh.polygons.push_back(std::move(triangle));
  }
  return mesh;
}

/// The first word after "solid", unless it is a statement such as SPACE=LPS.
std::string nameOf(std::string_view line) {
  const std::string_view name = TextScanner(line).word();
  return name.find('=') == std::string_view::npos ? std::string(name) : std::string();
}

PolygonMesh readAscii(const std::string& bytes, const std::filesystem::path& path) {
  const auto broken = [&]() -> IoError {
    return {"the STL text is truncated or damaged", path.string(), kCopyAgain};
  };
  PolygonMesh mesh;
  PointMerger merger(mesh.points);
  GroupsByName solids(mesh);
  std::uint32_t solid = 0;
  TextScanner scan(bytes);
  bool ended = false;
  std::vector<std::uint32_t> face;
  while (!scan.done()) {
    const std::string_view word = scan.word();
    if (word == "vertex") {
      double x = 0.0;
      double y = 0.0;
      double z = 0.0;
      if (!scan.number(x) || !scan.number(y) || !scan.number(z)) throw broken();
      face.push_back(merger.add(x, y, z));
    } else if (word == "endfacet") {
      if (face.size() < 3 || mesh.groupNames.empty()) throw broken();
      mesh.polygons.push_back(face);
      mesh.groups.push_back(solid);
      face.clear();
    } else if (word == "endsolid") {
      ended = true;
      mesh.header.read(scan.line());
    } else if (word == "facet") {
      ended = false;
    } else if (word == "solid") {
      // Any word may be in a name, so the line is taken as a whole.
      const std::string_view line = scan.line();
      mesh.header.read(line);
      solid = solids.number(nameOf(line));
    }
  }
  if (!ended || !face.empty()) throw broken();
  return mesh;
}

}  // namespace

PolygonMesh readStl(const std::string& bytes, const std::filesystem::path& path) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader) std::memcpy(&count, bytes.data() + 80, sizeof(count));
  const std::size_t expected = kHeader + kRecord * static_cast<std::size_t>(count);
  // Some binary files begin with "solid" as well: the size decides.
  if (bytes.size() >= kHeader && bytes.size() == expected) return readBinary(bytes, count);
  const std::string head = bytes.substr(0, 2000);
  if (head.starts_with("solid") && head.find('\0') == std::string::npos)
    return readAscii(bytes, path);
  if (bytes.size() < kHeader)
    throw InputError("not an STL file", path.string(), "give .ply, .stl, .obj, .vtp or .vtk");
  if (bytes.size() > expected) {
    // Trailing bytes are harmless, unless the count is not one.
    if (count == 0)
      throw InputError("not an STL file", path.string(), "give .ply, .stl, .obj, .vtp or .vtk");
    return readBinary(bytes, count);
  }
  throw IoError("the STL file is truncated or not an STL file (" + std::to_string(bytes.size()) +
                    " of " + std::to_string(expected) + " bytes)",
                path.string(), kCopyAgain);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/error.h"
#include "io/file/files.h"
#include "io/file/text_scanner.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/point_merger.h"
#include "io/mesh/polygon_mesh.h"

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

PolygonMesh readAscii(std::string_view bytes, const std::filesystem::path& path) {
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
    const std::string word = inSmall(std::string(scan.word()));
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
      solid = solids.number(wholeName(line));
    }
  }
  if (!ended || !face.empty()) throw broken();
  if (solids.again() > 0)
    mesh.remarks.push_back(
        (solids.again() == 1
             ? "a solid has the name of an earlier one and is"
             : std::to_string(solids.again()) + " solids have the names of earlier ones and are") +
        std::string(" one patch with it: give each a name of its own to keep them apart"));
  return mesh;
}

}  // namespace

PolygonMesh readStl(const std::string& bytes, const std::filesystem::path& path) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader) std::memcpy(&count, bytes.data() + 80, sizeof(count));
  const std::size_t expected = kHeader + kRecord * static_cast<std::size_t>(count);
  // Some binary files begin with "solid" as well: the size decides.
  if (bytes.size() >= kHeader && bytes.size() == expected) return readBinary(bytes, count);
  std::string_view text = bytes;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const std::string head = inSmall(std::string(text.substr(0, 2000)));
  if (head.starts_with("solid") && head.find('\0') == std::string::npos)
    return readAscii(text, path);
  if (bytes.size() < kHeader)
    throw InputError("not an STL file", path.string(), "give " + meshEndings(false));
  if (bytes.size() > expected) {
    if (count == 0)
      throw InputError("not an STL file", path.string(), "give " + meshEndings(false));
    PolygonMesh mesh = readBinary(bytes, count);
    mesh.remarks.push_back(leftBytes(bytes.size() - expected));
    return mesh;
  }
  throw IoError("the STL file is truncated or not an STL file (" + std::to_string(bytes.size()) +
                    " of " + std::to_string(expected) + " bytes)",
                path.string(), kCopyAgain);
}

}  // namespace angiomesh

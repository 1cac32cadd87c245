// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstring>
#include <unordered_map>

#include "core/base/error.h"
#include "io/polygon_mesh.h"
#include "io/text_scanner.h"

namespace angiomesh {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kRecord = 50;

struct PointHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const double x : p) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Gives equal points one number: an STL file repeats each point in every triangle.
class PointMerger {
 public:
  explicit PointMerger(std::vector<Eigen::Vector3d>& points) : points_(points) {}

  std::uint32_t add(double x, double y, double z) {
    // + 0.0 makes -0 and 0 the same bits.
    const std::array<double, 3> key{x + 0.0, y + 0.0, z + 0.0};
    const auto [entry, isNew] = index_.emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (isNew) points_.emplace_back(key[0], key[1], key[2]);
    return entry->second;
  }

 private:
  std::vector<Eigen::Vector3d>& points_;
  std::unordered_map<std::array<double, 3>, std::uint32_t, PointHash> index_;
};

PolygonMesh readBinary(const std::string& bytes, std::uint32_t count) {
  PolygonMesh mesh;
  readFrameAndUnit(bytes.substr(0, 80), mesh);
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

PolygonMesh readAscii(const std::string& bytes, const std::filesystem::path& path) {
  const auto broken = [&]() -> IoError {
    return {"the STL text is truncated or damaged", path.string(), "copy or download it again"};
  };
  PolygonMesh mesh;
  PointMerger merger(mesh.points);
  TextScanner scan(bytes);
  readFrameAndUnit(std::string(scan.line()), mesh);
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
      if (face.size() < 3) throw broken();
      mesh.polygons.push_back(face);
      face.clear();
    } else if (word == "endsolid") {
      ended = true;
      scan.line();
    } else if (word == "facet") {
      ended = false;
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
                path.string(), "copy or download it again");
}

}  // namespace angiomesh

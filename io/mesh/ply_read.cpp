// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "core/base/error.h"
#include "core/openings/port.h"
#include "io/file/mesh_number.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPatch = "patch";

struct Property {
  std::string name;
  Scalar type = Scalar::None;
  Scalar countType = Scalar::None;  ///< of a list; None: not a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::Ascii;
  std::vector<Element> elements;
  std::map<std::uint32_t, std::string> patches;  ///< names
};

[[noreturn]] void broken(const fs::path& path, const std::string& what) {
  throw InputError("the PLY header is not usable (" + what + ")", path.string(),
                   "write the mesh again with another program");
}

Scalar scalarOf(std::string_view name, const fs::path& path) {
  static const std::map<std::string_view, Scalar> types = {
      {"char", Scalar::Int8},      {"int8", Scalar::Int8},       {"uchar", Scalar::Uint8},
      {"uint8", Scalar::Uint8},    {"short", Scalar::Int16},     {"int16", Scalar::Int16},
      {"ushort", Scalar::Uint16},  {"uint16", Scalar::Uint16},   {"int", Scalar::Int32},
      {"int32", Scalar::Int32},    {"uint", Scalar::Uint32},     {"uint32", Scalar::Uint32},
      {"float", Scalar::Float32},  {"float32", Scalar::Float32}, {"double", Scalar::Float64},
      {"float64", Scalar::Float64}};
  const auto found = types.find(name);
  if (found == types.end()) broken(path, "unknown type '" + std::string(name) + "'");
  return found->second;
}

/// Of a comment: "patch 1 inlet".
void readPatchName(TextScanner& comment, Header& header) {
  double number = -1.0;
  if (comment.word() != "patch" || !comment.number(number)) return;
  const std::string name = wholeName(comment.rest());
  if (number >= 0.0 && number <= 65535.0 && !name.empty())
    header.patches.emplace(static_cast<std::uint32_t>(number), name);
}

Header readHeader(TextScanner& lines, PolygonMesh& mesh, const fs::path& path) {
  Header header;
  if (lines.line() != "ply") throw InputError("not a PLY file", path.string(), "check the file");
  bool hasFormat = false;
  while (!lines.done()) {
    const std::string_view text = lines.line();
    TextScanner scan(text);
    const std::string_view key = scan.word();
    if (key == "end_header") {
      if (!hasFormat) broken(path, "no format line");
      return header;
    }
    if (key == "format") {
      const std::string_view format = scan.word();
      if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
        broken(path, "unknown format");
      header.encoding = format == "ascii"               ? Encoding::Ascii
                        : format == "binary_big_endian" ? Encoding::BigEndian
                                                        : Encoding::LittleEndian;
      hasFormat = true;
    } else if (key == "comment" || key == "obj_info") {
      mesh.header.read(text);
      readPatchName(scan, header);
    } else if (key == "element") {
      Element element;
      element.name = scan.word();
      double count = -1.0;
      if (!scan.number(count) || count < 0.0 || count > 4e9) broken(path, "number of elements");
      element.count = static_cast<std::uint64_t>(count);
      header.elements.push_back(std::move(element));
    } else if (key == "property") {
      if (header.elements.empty()) broken(path, "a property before the first element");
      Property property;
      std::string_view type = scan.word();
      if (type == "list") {
        property.countType = scalarOf(scan.word(), path);
        type = scan.word();
      }
      property.type = scalarOf(type, path);
      property.name = scan.word();
      header.elements.back().properties.push_back(std::move(property));
    }
  }
  throwTruncated(path);
}

/// Refuses an element of more rows than the rest of the file can hold, before any is read.
void checkCount(const Element& element, Encoding encoding, std::size_t rest, const fs::path& path) {
  std::size_t row = 0;
  for (const Property& property : element.properties)
    // In text, a number takes a digit and a blank.
    row += encoding == Encoding::Ascii
               ? 2
               : bytesOf(property.countType == Scalar::None ? property.type : property.countType);
  if (row > 0 && element.count > (rest + 1) / row)
    throw IoError("the mesh file is truncated or damaged (" + std::to_string(element.count) +
                      " rows of '" + element.name + "' announced, " + std::to_string(rest) +
                      " bytes left)",
                  path.string(), "copy it again or write it with another program");
}

/// The numbers behind the header, one after the other.
class Body {
 public:
  Body(const TextScanner& text, Encoding encoding, const fs::path& path)
      : text_(text), encoding_(encoding), path_(path) {}

  double next(Scalar type) { return takeNumber(text_, encoding_, type, path_); }
  [[nodiscard]] std::size_t rest() const { return text_.rest().size(); }

 private:
  TextScanner text_;
  Encoding encoding_;
  const fs::path& path_;
};

std::uint32_t indexOf(double value, const fs::path& path) {
  if (!(value >= 0.0) || value > 4294967295.0)
    throw InputError("a face names a point that does not exist", path.string(),
                     "write the mesh again with another program");
  return static_cast<std::uint32_t>(value);
}

void readVertices(const Element& element, Body& body, PolygonMesh& mesh) {
  for (std::uint64_t i = 0; i < element.count; ++i) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (const Property& property : element.properties) {
      const double value = body.next(property.type);
      if (property.name == "x") p.x() = value;
      if (property.name == "y") p.y() = value;
      if (property.name == "z") p.z() = value;
    }
    mesh.points.push_back(p);
  }
}

/// As Stanford's scans have them: strips of triangles one after the other, each ended by -1.
void readStrips(const Element& element, Body& body, PolygonMesh& mesh, const fs::path& path) {
  std::vector<std::uint32_t> strip;
  std::vector<std::vector<std::uint32_t>> triangles;
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const Property& property : element.properties) {
      const bool isList = property.countType != Scalar::None;
      const double count = isList ? body.next(property.countType) : 1.0;
      if (!(count >= 0.0) || count > static_cast<double>(body.rest())) throwTruncated(path);
      const bool corners =
          isList && (property.name == "vertex_indices" || property.name == "vertex_index");
      for (double c = 0.0; c < count; ++c) {
        const double value = body.next(property.type);
        if (!corners) continue;
        if (value >= 0.0) strip.push_back(indexOf(value, path));
        if (value >= 0.0 && c + 1.0 < count) continue;
        appendStrip(strip, triangles);
        strip.clear();
      }
    }
  // Strips are joined by triangles that name a corner twice.
  for (auto& triangle : triangles)
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      mesh.polygons.push_back(std::move(triangle));
}

/// Faces with their patches, or an element of no interest (`mesh` null).
void readRows(const Element& element, Body& body, PolygonMesh* mesh, std::vector<double>& patches,
              const fs::path& path) {
  for (std::uint64_t i = 0; i < element.count; ++i)
    for (const Property& property : element.properties) {
      if (property.countType == Scalar::None) {
        const double value = body.next(property.type);
        if (mesh != nullptr && property.name == kPatch) patches.push_back(value);
        continue;
      }
      const bool corners =
          mesh != nullptr && (property.name == "vertex_indices" || property.name == "vertex_index");
      const double count = body.next(property.countType);
      const auto rest = static_cast<double>(body.rest());
      if (!(count >= 0.0) || count > rest || (corners && count < 3.0)) throwTruncated(path);
      std::vector<std::uint32_t> polygon;
      for (double c = 0.0; c < count; ++c) {
        const double value = body.next(property.type);
        if (corners) polygon.push_back(indexOf(value, path));
      }
      if (corners) mesh->polygons.push_back(std::move(polygon));
    }
}

}  // namespace

PolygonMesh readPly(const std::string& bytes, const fs::path& path) {
  PolygonMesh mesh;
  TextScanner lines(bytes);
  Header header = readHeader(lines, mesh, path);
  Body body(lines, header.encoding, path);
  std::vector<double> patches;
  for (const Element& element : header.elements) {
    const auto has = [&](const char* name) {
      for (const Property& property : element.properties)
        if (property.name == name && property.countType == Scalar::None) return true;
      return false;
    };
    if (element.properties.empty()) continue;
    checkCount(element, header.encoding, body.rest(), path);
    if (element.name == "vertex" || element.name == "face")
      mesh.hasQuality = mesh.hasQuality || has("quality");
    if (element.name == "vertex") {
      if (!has("x") || !has("y") || !has("z")) broken(path, "a vertex without x, y, z");
      for (const Property& property : element.properties)
        if (property.countType != Scalar::None) broken(path, "a list in a vertex");
      mesh.hasNormals = has("nx") && has("ny") && has("nz");
      readVertices(element, body, mesh);
    } else if (element.name == "tristrips") {
      readStrips(element, body, mesh, path);
    } else {
      readRows(element, body, element.name == "face" ? &mesh : nullptr, patches, path);
    }
  }
  if (const std::size_t rest = body.rest(); rest > 0) {
    const std::string_view left = std::string_view(bytes).substr(bytes.size() - rest);
    if (left.find_first_not_of(" \t\r\n\f\v") != std::string_view::npos)
      mesh.remarks.push_back(leftBytes(rest));
  }
  if (!patches.empty()) {
    header.patches.try_emplace(0, kWallName);
    groupByNumber(mesh, patches, header.patches, "patch_");
  }
  return mesh;
}

}  // namespace angiomesh

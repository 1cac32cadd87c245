// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "io/mesh_text.h"
#include "io/polygon_mesh.h"

namespace angiomesh {
namespace {

Eigen::Vector3d normalOf(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Eigen::Vector3d& a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).stableNormalized();
}

/// A solid's name is one word, and no statement of a frame or unit.
std::string cleanName(const std::string& name) {
  std::string clean;
  for (const char c : name) clean += c > ' ' && c < 127 && c != '=' ? c : '_';
  return clean.empty() ? "surface" : clean;
}

/// In the order of the triangles, with names that are usable and different.
std::vector<MeshPart> checkedParts(const WritableMesh& mesh, const std::filesystem::path& path) {
  const auto refused = [&](const std::string& name, const std::string& what) -> InputError {
    return {"the part '" + cleanName(name) + "' " + what, path.string(),
            "give parts that hold all triangles, each once"};
  };
  const std::size_t count = mesh.mesh.triangles.size();
  std::vector<MeshPart> parts = mesh.options.parts;
  if (parts.empty()) parts.push_back({"surface", 0, count});
  std::stable_sort(parts.begin(), parts.end(), [](const MeshPart& a, const MeshPart& b) {
    return a.first != b.first ? a.first < b.first : a.count < b.count;
  });
  std::size_t next = 0;
  std::set<std::string> names;
  for (MeshPart& part : parts) {
    if (part.first > count || part.count > count - part.first)
      throw refused(part.name, "names triangles that do not exist");
    if (part.first < next) throw refused(part.name, "overlaps another part");
    if (part.first > next) throw refused(part.name, "leaves out the triangles before it");
    next = part.first + part.count;
    const std::string name = cleanName(part.name);
    part.name = name;
    for (int number = 2; !names.insert(part.name).second; ++number)
      part.name = name + "-" + std::to_string(number);
  }
  if (next != count) throw refused(parts.back().name, "leaves out the triangles after it");
  return parts;
}

}  // namespace

std::string stlText(const WritableMesh& mesh, const std::filesystem::path& path) {
  const auto appendVector = [](std::string& text, const Eigen::Vector3d& v) {
    for (int a = 0; a < 3; ++a) {
      text += ' ';
      appendScientific(text, v[a]);
    }
    text += '\n';
  };
  std::string text;
  for (const MeshPart& part : checkedParts(mesh, path)) {
    // An ASCII STL file has no comments: the line of the name is where 3D Slicer looks.
    text += "solid " + part.name + " " + headerWords(mesh.options, " ") + "\n";
    for (std::size_t t = part.first; t < part.first + part.count; ++t) {
      text += "facet normal";
      appendVector(text, normalOf(mesh.mesh, mesh.mesh.triangles[t]));
      text += " outer loop\n";
      for (const std::uint32_t corner : mesh.mesh.triangles[t]) {
        text += "  vertex";
        appendVector(text, mesh.mesh.points[corner]);
      }
      text += " endloop\nendfacet\n";
    }
    text += "endsolid " + part.name + "\n";
  }
  return text;
}

std::string stlBytes(const WritableMesh& mesh) {
  // Readers take a file that begins with "solid" for ASCII.
  std::string bytes = "Angiomesh " + headerWords(mesh.options, " ");
  bytes.resize(80, ' ');
  appendRaw(bytes, static_cast<std::uint32_t>(mesh.mesh.triangles.size()));
  bytes.reserve(84 + 50 * mesh.mesh.triangles.size());
  for (const auto& t : mesh.mesh.triangles) {
    const Eigen::Vector3d normal = normalOf(mesh.mesh, t);
    for (int i = 0; i < 3; ++i) appendRaw(bytes, static_cast<float>(normal[i]));
    for (const std::uint32_t corner : t)
      for (int i = 0; i < 3; ++i) appendRaw(bytes, static_cast<float>(mesh.mesh.points[corner][i]));
    appendRaw(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace angiomesh

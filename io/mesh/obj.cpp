// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <optional>

#include "core/base/error.h"
#include "io/file/mesh_text.h"
#include "io/file/text_scanner.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {
namespace {

/// What the format calls the group of faces before the first one.
constexpr std::string_view kDefaultGroup = "default";

bool hasLineOf(std::string_view text, std::string_view kind) {
  for (TextScanner lines(text); !lines.done();)
    if (TextScanner(lines.line()).word() == kind) return true;
  return false;
}

}  // namespace

PolygonMesh readObj(const std::string& bytes, const std::filesystem::path& path) {
  const auto broken = [&](int line) -> InputError {
    return {"line " + std::to_string(line) + " of the OBJ file is not usable", path.string(),
            "copy it again or write it with another program"};
  };
  PolygonMesh mesh;
  // Objects hold groups: they count where there are no groups.
  const bool hasGroups = hasLineOf(bytes, "g");
  GroupsByName groups(mesh);
  std::optional<std::uint32_t> group;
  TextScanner lines(bytes);
  std::string joined;
  for (int number = 1; !lines.done(); ++number) {
    std::string_view text = lines.line();
    if (text.ends_with('\\') && !text.starts_with('#')) {
      joined.clear();
      for (; text.ends_with('\\') && !lines.done(); ++number) {
        joined += text.substr(0, text.size() - 1);
        joined += ' ';
        text = lines.line();
      }
      text = joined += text;
    }
    TextScanner scan(text);
    const std::string_view kind = scan.word();
    if (kind.starts_with('#')) {
      mesh.header.read(text);
    } else if (kind == "v") {
      Eigen::Vector3d p;
      for (int a = 0; a < 3; ++a)
        if (!scan.number(p[a])) throw broken(number);
      mesh.points.push_back(p);
    } else if (kind == "vn") {
      mesh.hasNormals = true;
    } else if (kind == (hasGroups ? "g" : "o")) {
      const std::string name = wholeName(scan.rest());
      group = groups.number(name.empty() ? kDefaultGroup : std::string_view(name));
    } else if (kind == "f") {
      std::vector<std::uint32_t> polygon;
      for (std::string_view corner = scan.word(); !corner.empty(); corner = scan.word()) {
        long long index = 0;
        // "7", "7/1" or "7/1/2": only the point counts. Negative numbers count from the end.
        const char* const last = corner.data() + corner.size();
        const auto [end, error] = std::from_chars(corner.data(), last, index);
        if (error != std::errc() || (end != last && *end != '/')) throw broken(number);
        const auto points = static_cast<long long>(mesh.points.size());
        index = index < 0 ? points + index : index - 1;
        if (index < 0 || index >= points) throw broken(number);
        polygon.push_back(static_cast<std::uint32_t>(index));
      }
      if (polygon.size() < 3) throw broken(number);
      mesh.polygons.push_back(std::move(polygon));
      if (!group) group = groups.number(kDefaultGroup);
      mesh.groups.push_back(*group);
    }
  }
  // A name for everything that nobody gave.
  if (mesh.groupNames == std::vector<std::string>{std::string(kDefaultGroup)})
    mesh.groupNames.front().clear();
  return mesh;
}

std::string objBytes(const WritableMesh& mesh) {
  std::string text = "# Angiomesh\n# " + headerWords(mesh.options, "\n# ") + "\n";
  for (const Eigen::Vector3d& p : mesh.mesh.points) {
    text += 'v';
    for (int a = 0; a < 3; ++a) {
      text += ' ';
      appendShortest(text, p[a]);
    }
    text += '\n';
  }
  const auto patches = trianglesByPatch(mesh.mesh, mesh.patchNames.size());
  for (std::size_t patch = 0; patch < patches.size(); ++patch) {
    if (!mesh.mesh.patch.empty()) text += "g " + mesh.patchNames[patch] + "\n";
    for (const std::uint32_t t : patches[patch]) {
      text += 'f';
      for (const std::uint32_t corner : mesh.mesh.triangles[t])
        text += ' ' + std::to_string(corner + 1);
      text += '\n';
    }
  }
  return text;
}

}  // namespace angiomesh

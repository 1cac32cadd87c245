// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "io/file/mesh_text.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {
namespace {

Eigen::Vector3d normalOf(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Eigen::Vector3d& a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).stableNormalized();
}

}  // namespace

std::string stlText(const WritableMesh& mesh) {
  const auto appendVector = [](std::string& text, const Eigen::Vector3d& v) {
    for (int a = 0; a < 3; ++a) {
      text += ' ';
      appendScientific(text, v[a]);
    }
    text += '\n';
  };
  std::string text;
  const std::string words = " " + headerWords(mesh.options, " ");
  const auto patches = trianglesByPatch(mesh.mesh, mesh.patchNames.size());
  const bool named = patches.size() > 1 || !mesh.options.patchNames.empty();
  for (std::size_t patch = 0; patch < patches.size(); ++patch) {
    // The wall of a mesh of ports alone; a port without triangles keeps its place among the others.
    if (patch == 0 && patches[0].empty() && patches.size() > 1) continue;
    const std::string& name = mesh.patchNames[patch];
    // An ASCII STL file has no comments: the first line is where 3D Slicer looks. OpenFOAM and
    // others take all of that line for the name, so it stays free where names matter, unless the
    // frame is one that 3D Slicer does not take unsaid.
    const bool wordsFirst = !named || (mesh.options.frame == Frame::Ras && text.empty());
    text += "solid " + name + (wordsFirst ? words : "") + "\n";
    for (const std::uint32_t t : patches[patch]) {
      text += "facet normal";
      appendVector(text, normalOf(mesh.mesh, mesh.mesh.triangles[t]));
      text += " outer loop\n";
      for (const std::uint32_t corner : mesh.mesh.triangles[t]) {
        text += "  vertex";
        appendVector(text, mesh.mesh.points[corner]);
      }
      text += " endloop\nendfacet\n";
    }
    text += "endsolid " + name + (wordsFirst ? "" : words) + "\n";
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

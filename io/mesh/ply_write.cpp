// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "core/openings/port_colour.h"
#include "io/file/mesh_text.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {
namespace {

/// Of programs that show no other property of faces: the openings as in the window, the wall grey.
std::array<std::uint8_t, 3> colourOf(std::uint16_t patch) {
  if (patch == 0) return {204, 204, 204};
  std::array<std::uint8_t, 3> bytes{};
  const std::array<double, 3> colour = portColour(patch - 1U);
  for (std::size_t c = 0; c < 3; ++c)
    bytes[c] = static_cast<std::uint8_t>(std::lround(255.0 * colour[c]));
  return bytes;
}

std::string headerOf(const WritableMesh& mesh) {
  const bool binary = mesh.options.encoding == MeshEncoding::Binary;
  std::string text = "ply\nformat ";
  text += binary ? "binary_little_endian" : "ascii";
  text += " 1.0\ncomment Angiomesh\ncomment " + headerWords(mesh.options, "\ncomment ") + "\n";
  const bool patches = !mesh.mesh.patch.empty();
  for (std::size_t patch = 0; patches && patch < mesh.patchNames.size(); ++patch)
    text += "comment patch " + std::to_string(patch) + " " + mesh.patchNames[patch] + "\n";
  text += "element vertex " + std::to_string(mesh.mesh.points.size()) + "\n";
  text += "property double x\nproperty double y\nproperty double z\n";
  if (!mesh.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  text += "element face " + std::to_string(mesh.mesh.triangles.size()) + "\n";
  text += "property list uchar int vertex_indices\n";
  if (!mesh.quality.empty()) text += "property float quality\n";
  if (patches)
    text += "property int patch\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
  return text + "end_header\n";
}

void appendAscii(const WritableMesh& mesh, std::string& text) {
  for (std::size_t v = 0; v < mesh.mesh.points.size(); ++v) {
    for (int a = 0; a < 3; ++a) {
      if (a > 0) text += ' ';
      appendShortest(text, mesh.mesh.points[v][a]);
    }
    for (int a = 0; a < 3 && !mesh.normals.empty(); ++a) {
      text += ' ';
      appendShortest(text, static_cast<float>(mesh.normals[v][a]));
    }
    text += '\n';
  }
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    text += '3';
    for (const std::uint32_t corner : mesh.mesh.triangles[t]) text += ' ' + std::to_string(corner);
    if (!mesh.quality.empty()) {
      text += ' ';
      appendShortest(text, static_cast<float>(mesh.quality[t]));
    }
    if (!mesh.mesh.patch.empty()) {
      text += ' ' + std::to_string(mesh.mesh.patch[t]);
      for (const std::uint8_t part : colourOf(mesh.mesh.patch[t]))
        text += ' ' + std::to_string(part);
    }
    text += '\n';
  }
}

void appendBinary(const WritableMesh& mesh, std::string& bytes) {
  bytes.reserve(bytes.size() + mesh.mesh.points.size() * 36 + mesh.mesh.triangles.size() * 24);
  for (std::size_t v = 0; v < mesh.mesh.points.size(); ++v) {
    for (int a = 0; a < 3; ++a) appendRaw(bytes, mesh.mesh.points[v][a]);
    for (int a = 0; a < 3 && !mesh.normals.empty(); ++a)
      appendRaw(bytes, static_cast<float>(mesh.normals[v][a]));
  }
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    appendRaw(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : mesh.mesh.triangles[t])
      appendRaw(bytes, static_cast<std::int32_t>(corner));
    if (!mesh.quality.empty()) appendRaw(bytes, static_cast<float>(mesh.quality[t]));
    if (!mesh.mesh.patch.empty()) {
      appendRaw(bytes, std::int32_t{mesh.mesh.patch[t]});
      for (const std::uint8_t part : colourOf(mesh.mesh.patch[t])) appendRaw(bytes, part);
    }
  }
}

}  // namespace

std::string plyBytes(const WritableMesh& mesh) {
  std::string bytes = headerOf(mesh);
  if (mesh.options.encoding == MeshEncoding::Binary)
    appendBinary(mesh, bytes);
  else
    appendAscii(mesh, bytes);
  return bytes;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/mesh_text.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {

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

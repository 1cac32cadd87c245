// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_text.h"
#include "io/polygon_mesh.h"

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
  for (const auto& t : mesh.mesh.triangles) {
    text += 'f';
    for (const std::uint32_t corner : t) text += ' ' + std::to_string(corner + 1);
    text += '\n';
  }
  return text;
}

}  // namespace angiomesh

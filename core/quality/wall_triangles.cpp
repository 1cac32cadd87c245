// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/wall_triangles.h"

namespace angiomesh {
namespace {

/// Bit 2a: on or beyond the first voxel centres along axis a; bit 2a + 1: the last ones.
unsigned borderOf(const Eigen::Vector3d& index, const Index3& size) {
  constexpr double rounding = 1e-6;
  unsigned planes = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double last = size[axis] - 1;
    if (index[axis] < rounding) planes |= 1U << (2 * axis);
    if (index[axis] > last - rounding) planes |= 2U << (2 * axis);
  }
  return planes;
}

}  // namespace

std::vector<char> wallTriangles(const TriMesh& mesh, const Geometry& grid) {
  std::vector<unsigned> planes(mesh.points.size());
  for (std::size_t v = 0; v < planes.size(); ++v)
    planes[v] = borderOf(grid.toIndex(mesh.points[v]), grid.size);
  std::vector<char> wall(mesh.triangles.size());
  for (std::size_t t = 0; t < wall.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const bool patch = !mesh.patch.empty() && mesh.patch[t] != 0;
    wall[t] = !patch && (planes[a] & planes[b] & planes[c]) == 0 ? 1 : 0;
  }
  return wall;
}

}  // namespace angiomesh

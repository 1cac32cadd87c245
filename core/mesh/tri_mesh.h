// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace angiomesh {

/// An indexed triangle mesh in LPS mm; faces counter-clockwise seen from outside.
struct TriMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Per triangle: 0 the wall, 1 + n the cap of port n (see Port). Empty: all is wall.
  std::vector<std::uint16_t> patch = {};
};

inline bool repeatsVertex(const std::array<std::uint32_t, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// @throws InputError when a triangle names a vertex that is not there, a vertex is not finite, or
/// some triangles have a patch and others none
void checkMesh(const TriMesh& mesh);

double surfaceAreaMm2(const TriMesh& mesh);

/// Enclosed volume by the divergence theorem, positive for outward faces. Meaningful for closed
/// meshes.
double enclosedVolumeMm3(const TriMesh& mesh);

/// Unit normals of the vertices, triangles weighted by their area; 0 where there is none.
std::vector<Eigen::Vector3d> vertexNormals(const TriMesh& mesh);

/// Drops the edge-connected components whose enclosed volume is below `minimumMm3` (and points no
/// triangle uses). Returns the number of components dropped.
int dropSmallComponents(TriMesh& mesh, double minimumMm3);

/// Drops all edge-connected components but the one of most area. Returns how many those were.
int keepLargestComponent(TriMesh& mesh);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "core/base/random.h"
#include "tests/core/mesh_shapes.h"

namespace angiomesh::test {

/// An octahedron with uneven, not representable coordinates; faces outward.
inline TriMesh octahedron() {
  TriMesh mesh;
  const Eigen::Vector3d centre(10.1, -20.3, 0.7);
  for (int a = 0; a < 3; ++a)
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d p = centre;
      p[a] += side * (3.1 + a / 3.0);
      mesh.points.push_back(p);
    }
  for (std::uint32_t x = 0; x < 2; ++x)
    for (std::uint32_t y = 2; y < 4; ++y)
      for (std::uint32_t z = 4; z < 6; ++z) {
        const bool upright = (x + y + z) % 2 == 1;
        // Corners on +x, +y, +z run counter-clockwise; each mirrored axis turns them round.
        mesh.triangles.push_back(upright ? std::array<std::uint32_t, 3>{x, y, z}
                                         : std::array<std::uint32_t, 3>{x, z, y});
      }
  return mesh;
}

/// A closed tube about the z axis: patch 1 is the cap at z = 0, patch 2 the one at the other end;
/// each a fan about its centre.
inline TriMesh cappedTube(int around, int rings, double radius) {
  TriMesh mesh = shapes::openTube(around, rings, radius);
  mesh.patch.assign(mesh.triangles.size(), 0);
  const auto cap = [&](int ring, std::uint16_t patch) {
    const double z = mesh.points[static_cast<std::size_t>(ring * around)].z();
    const auto centre = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(0.0, 0.0, z);
    for (int i = 0; i < around; ++i) {
      auto a = static_cast<std::uint32_t>(ring * around + i);
      auto b = static_cast<std::uint32_t>(ring * around + (i + 1) % around);
      if (ring == 0) std::swap(a, b);
      mesh.triangles.push_back({centre, a, b});
      mesh.patch.push_back(patch);
    }
  };
  cap(0, 1);
  cap(rings - 1, 2);
  return mesh;
}

inline TriMesh insideOut(TriMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// A dented ball with a cavity, a dented torus and, for odd seeds, an open tube; somewhere in
/// patient space, each point off any grid.
inline TriMesh randomMesh(std::uint64_t seed) {
  std::uint64_t next = 0;
  const auto random = [&] { return randomNormal(seed, next++); };
  TriMesh mesh;
  const auto add = [&](TriMesh part, double size, double dent, const Eigen::Vector3d& at) {
    for (auto& p : part.points) p = at + size * (1.0 + dent * std::tanh(random())) * p;
    shapes::append(mesh, part);
  };
  const Eigen::Vector3d centre = 100.0 * Eigen::Vector3d(random(), random(), random());
  add(shapes::icosphere(2), 8.0, 0.1, centre);
  add(insideOut(shapes::icosphere(1)), 3.0, 0.1, centre);
  add(shapes::torus(20, 9, 5.0, 1.0), 1.5, 0.01, centre + Eigen::Vector3d(30, 0, 0));
  if (seed % 2 == 1)
    add(shapes::openTube(10, 6, 1.0), 2.0, 0.01, centre - Eigen::Vector3d(30, 0, 0));
  return mesh;
}

/// Largest distance between corners of corresponding triangles, whatever the points' numbers.
inline double largestDifference(const TriMesh& a, const TriMesh& b) {
  if (a.triangles.size() != b.triangles.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(
          largest,
          (a.points[a.triangles[t][c]] - b.points[b.triangles[t][c]]).cwiseAbs().maxCoeff());
  return largest;
}

/// Of points with a colour, and of polygons.
inline std::string plyHeader(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement "
         "face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_index\nend_header\n";
}

}  // namespace angiomesh::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "core/base/random.h"
#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "tests/core/analytic.h"

// Meshes and fields with known properties.
namespace angiomesh::shapes {

inline constexpr double pi = 3.14159265358979323846;

/// Anisotropic, rotated, off-centre; mirrored: determinant of the direction -1.
inline Geometry obliqueGeometry(const Index3& size, bool mirrored = false) {
  Geometry g;
  g.size = size;
  g.spacing = {0.4, 0.5, 0.7};
  g.origin = {-112.0, 83.0, 41.0};
  g.direction = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  if (mirrored) g.direction.col(1) *= -1.0;
  return g;
}

using analytic::sampled;

/// Independent standard normal values.
inline Volume<float> noise(const Index3& size, std::uint64_t seed) {
  Geometry g;
  g.size = size;
  Volume<float> volume(g);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
    volume.voxels[i] = static_cast<float>(randomNormal(seed, i));
  }
  return volume;
}

inline TriMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/// Two tetrahedra with one corner in common, opposite to one another.
inline TriMesh touchingTetrahedra() {
  TriMesh mesh = tetrahedron();
  mesh.points.insert(mesh.points.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  for (const auto& t : tetrahedron().triangles) {
    std::array<std::uint32_t, 3> other{};
    for (std::size_t k = 0; k < 3; ++k) other[k] = t[2 - k] == 0 ? 0 : t[2 - k] + 3;
    mesh.triangles.push_back(other);
  }
  return mesh;
}

/// Edge 1, volume 1, each side cut along a diagonal.
inline TriMesh cube() {
  TriMesh mesh;
  for (int v = 0; v < 8; ++v) mesh.points.emplace_back(v & 1, (v >> 1) & 1, (v >> 2) & 1);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline TriMesh icosahedron() {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  TriMesh mesh;
  mesh.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (auto& p : mesh.points) p.normalize();
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// The icosahedron with each triangle cut into four `levels` times, on the unit sphere.
inline TriMesh icosphere(int levels) {
  TriMesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto key = std::minmax(a, b);
      const auto found = middles.find(key);
      if (found != middles.end()) return found->second;
      mesh.points.push_back((mesh.points[a] + mesh.points[b]).normalized());
      return middles[key] = static_cast<std::uint32_t>(mesh.points.size() - 1);
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& t : mesh.triangles) {
      const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.push_back({t[0], ab, ca});
      finer.push_back({t[1], bc, ab});
      finer.push_back({t[2], ca, bc});
      finer.push_back({ab, bc, ca});
    }
    mesh.triangles = finer;
  }
  return mesh;
}

inline TriMesh torus(int around, int across, double major, double minor) {
  TriMesh mesh;
  const auto id = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * pi * i / around, v = 2.0 * pi * j / across;
      const double r = major + minor * std::cos(v);
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

/// An open tube about the z axis with near-equilateral triangles: `rings` rings of `around`
/// vertices, every other ring turned by half an edge.
inline TriMesh openTube(int around, int rings, double radius) {
  TriMesh mesh;
  const double edge = 2.0 * radius * std::sin(pi / around);
  const auto id = [&](int ring, int i) {
    return static_cast<std::uint32_t>(ring * around + (i + around) % around);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * pi * (i + 0.5 * (ring % 2)) / around;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                               ring * edge * std::sqrt(0.75));
    }
  }
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      if (ring % 2 == 0) {
        mesh.triangles.push_back({id(ring, i), id(ring, i + 1), id(ring + 1, i)});
        mesh.triangles.push_back({id(ring, i + 1), id(ring + 1, i + 1), id(ring + 1, i)});
      } else {
        mesh.triangles.push_back({id(ring, i), id(ring, i + 1), id(ring + 1, i + 1)});
        mesh.triangles.push_back({id(ring, i), id(ring + 1, i + 1), id(ring + 1, i)});
      }
    }
  }
  return mesh;
}

inline void append(TriMesh& mesh, const TriMesh& other) {
  const auto shift = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) {
    for (auto& v : t) v += shift;
    mesh.triangles.push_back(t);
  }
}

inline TriMesh moved(TriMesh mesh, const Eigen::Vector3d& by) {
  for (auto& p : mesh.points) p += by;
  return mesh;
}

}  // namespace angiomesh::shapes

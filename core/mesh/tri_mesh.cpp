// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/tri_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {
namespace {

// Six times the signed volume of the tetrahedron over one triangle. Taken about a point near the
// mesh: about the origin of patient space, volumes of small vessels would drown in cancellation.
double sixfoldVolume(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t,
                     const Eigen::Vector3d& about) {
  const Eigen::Vector3d a = mesh.points[t[0]] - about;
  const Eigen::Vector3d b = mesh.points[t[1]] - about;
  const Eigen::Vector3d c = mesh.points[t[2]] - about;
  return a.dot(b.cross(c));
}

double twiceAreaMm2(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Eigen::Vector3d& a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).norm();
}

/// Returns the number of components dropped.
int keepComponents(TriMesh& mesh, const MeshComponents& components, const std::vector<bool>& keep) {
  const auto dropped = std::count(keep.begin(), keep.end(), false);
  TriMesh kept;
  constexpr std::uint32_t unused = 0xffffffffU;
  std::vector<std::uint32_t> renumbered(mesh.points.size(), unused);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!keep[components.label[i]]) continue;
    kept.triangles.push_back(mesh.triangles[i]);
    if (!mesh.patch.empty()) kept.patch.push_back(mesh.patch[i]);
  }
  for (const auto& t : kept.triangles) {
    for (const std::uint32_t v : t) renumbered[v] = 0;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (renumbered[v] == unused) continue;
    renumbered[v] = static_cast<std::uint32_t>(kept.points.size());
    kept.points.push_back(mesh.points[v]);
  }
  for (auto& t : kept.triangles) {
    for (std::uint32_t& v : t) v = renumbered[v];
  }
  mesh = std::move(kept);
  return static_cast<int>(dropped);
}

}  // namespace

void checkMesh(const TriMesh& mesh) {
  if (!mesh.patch.empty() && mesh.patch.size() != mesh.triangles.size())
    throw InputError("patches are given for " + std::to_string(mesh.patch.size()) + " of " +
                         std::to_string(mesh.triangles.size()) + " triangles",
                     "mesh", "repair or re-export the mesh file");
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      if (v >= mesh.points.size()) {
        throw InputError("a triangle names vertex " + std::to_string(v) + " of " +
                             std::to_string(mesh.points.size()),
                         "mesh", "repair or re-export the mesh file");
      }
    }
  }
  for (const auto& p : mesh.points) {
    if (!p.allFinite()) {
      throw InputError("a vertex is not a number", "mesh", "repair or re-export the mesh file");
    }
  }
}

double surfaceAreaMm2(const TriMesh& mesh) {
  double twice = 0.0;
  for (const auto& t : mesh.triangles) twice += twiceAreaMm2(mesh, t);
  return twice / 2.0;
}

double enclosedVolumeMm3(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  const Eigen::Vector3d about = mesh.points[mesh.triangles.front()[0]];
  double sixfold = 0.0;
  for (const auto& t : mesh.triangles) sixfold += sixfoldVolume(mesh, t, about);
  return sixfold / 6.0;
}

std::vector<Eigen::Vector3d> vertexNormals(const TriMesh& mesh) {
  std::vector<Eigen::Vector3d> normals(mesh.points.size(), Eigen::Vector3d::Zero());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.points[t[0]];
    const Eigen::Vector3d n = (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a);
    for (const std::uint32_t v : t) normals[v] += n;
  }
  for (auto& n : normals) {
    const double length = n.norm();
    if (length > 0.0) n /= length;
  }
  return normals;
}

int dropSmallComponents(TriMesh& mesh, double minimumMm3) {
  const MeshComponents components = meshComponents(mesh);
  std::vector<double> sixfold(components.count, 0.0);
  std::vector<Eigen::Vector3d> about(components.count);
  std::vector<bool> met(components.count, false);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t c = components.label[i];
    if (!met[c]) about[c] = mesh.points[mesh.triangles[i][0]];
    met[c] = true;
    sixfold[c] += sixfoldVolume(mesh, mesh.triangles[i], about[c]);
  }
  std::vector<bool> keep(components.count);
  for (std::size_t c = 0; c < components.count; ++c) keep[c] = !(sixfold[c] / 6.0 < minimumMm3);
  return keepComponents(mesh, components, keep);
}

int keepLargestComponent(TriMesh& mesh) {
  const MeshComponents components = meshComponents(mesh);
  if (components.count < 2) return 0;
  // Not by triangles: a thin vessel may have more of them than a thick one.
  std::vector<double> twice(components.count, 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    twice[components.label[i]] += twiceAreaMm2(mesh, mesh.triangles[i]);
  std::vector<bool> keep(components.count, false);
  keep[static_cast<std::size_t>(std::max_element(twice.begin(), twice.end()) - twice.begin())] =
      true;
  return keepComponents(mesh, components, keep);
}

}  // namespace angiomesh

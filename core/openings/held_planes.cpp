// SPDX-License-Identifier: BSD-3-Clause
#include "core/openings/held_planes.h"

#include <Eigen/Geometry>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"
#include "core/openings/end_planes.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// What single precision leaves of a plane, voxels.
constexpr double kHair = 1e-4;

std::vector<char> onOpenRim(const TriMesh& mesh) {
  std::vector<char> rim(mesh.points.size(), 0);
  for (const RimEdge& edge : rimEdges(mesh))
    if (edge.open) rim[edge.from] = rim[edge.to] = 1;
  return rim;
}

}  // namespace

HeldPlanes::HeldPlanes(const TriMesh& mesh, const Geometry* grid, const std::vector<Port>& ports)
    : of_(mesh.points.size(), {none, none}), cap_(mesh.triangles.size(), 0) {
  if (grid != nullptr) holdInBorders(mesh, *grid);
  std::uint16_t patches = 0;
  for (const std::uint16_t patch : mesh.patch) patches = std::max(patches, patch);
  const std::vector<Port> measured = measurePatches(mesh, patches);
  std::vector<std::uint16_t> plane;
  for (const Port& port : measured)
    plane.push_back(port.areaMm2 > 0.0 ? planeOf(port.normalLps) : none);
  for (std::size_t t = 0; t < mesh.patch.size(); ++t) {
    if (mesh.patch[t] == 0) continue;
    cap_[t] = 1;
    // A cap in a border plane is held there already.
    for (const std::uint32_t v : mesh.triangles[t]) hold(v, plane[mesh.patch[t] - 1U]);
  }
  std::vector<char> rim;
  for (std::size_t n = 0; n < ports.size(); ++n) {
    const Port& port = ports[n];
    if (!(port.areaMm2 > 0.0) || (n < measured.size() && measured[n].areaMm2 > 0.0)) continue;
    if (rim.empty()) rim = onOpenRim(mesh);
    const std::uint16_t number = planeOf(port.normalLps);
    for (std::uint32_t v = 0; v < rim.size(); ++v)
      if (rim[v] != 0 && port.opensAt(mesh.points[v])) hold(v, number);
  }
}

void HeldPlanes::holdInBorders(const TriMesh& mesh, const Geometry& grid) {
  const EndPlanes borders(grid);
  for (int a = 0; a < borders.count(); ++a) normals_.push_back(borders.normal(a));
  const Eigen::Matrix3d toIndex = grid.physicalToIndexMatrix();
  std::vector<std::uint8_t> in(mesh.points.size(), 0);
  parallelForEach(in.size(), 1024, [&](std::size_t v) {
    const Vector3d index = toIndex * (mesh.points[v] - grid.origin);
    for (std::size_t a = 0; a < 3; ++a) {
      const double at = index[static_cast<Eigen::Index>(a)], end = grid.size[a] - 1;
      if (at < kHair) in[v] |= static_cast<std::uint8_t>(1U << (2 * a));
      if (at > end - kHair) in[v] |= static_cast<std::uint8_t>(2U << (2 * a));
    }
    for (std::uint16_t a = 0; a < 6; ++a)
      if ((in[v] >> a & 1U) != 0) hold(static_cast<std::uint32_t>(v), a);
  });
  for (std::size_t t = 0; t < cap_.size(); ++t) {
    const auto& c = mesh.triangles[t];
    if ((in[c[0]] & in[c[1]] & in[c[2]]) != 0) cap_[t] = 1;
  }
}

// A plane of this normal: parallel ones are told apart by their vertices.
std::uint16_t HeldPlanes::planeOf(const Vector3d& normal) {
  for (std::size_t a = 0; a < normals_.size(); ++a)
    if (normals_[a].dot(normal) > 1.0 - 1e-10) return static_cast<std::uint16_t>(a);
  normals_.push_back(normal);
  return static_cast<std::uint16_t>(normals_.size() - 1);
}

void HeldPlanes::hold(std::uint32_t v, std::uint16_t plane) {
  std::array<std::uint16_t, 2>& of = of_[v];
  if (plane == none || of[0] == plane || of[1] == plane) return;
  (of[0] == none ? of[0] : of[1]) = plane;
}

bool HeldPlanes::sharePlane(std::uint32_t v, std::uint32_t w) const {
  for (const std::uint16_t a : of_[v])
    for (const std::uint16_t b : of_[w])
      if (a != none && a == b) return true;
  return false;
}

}  // namespace angiomesh

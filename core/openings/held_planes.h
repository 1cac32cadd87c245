// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"
#include "core/openings/port.h"

namespace angiomesh {

/// The planes that vertices of a finished surface have to stay in: those of its patches, those of
/// open rims at ports, and the outermost planes of voxel centres.
class HeldPlanes {
 public:
  /// `grid` may be null: no border planes. `ports` tell open rims; those with triangles of their
  /// own are known from the mesh.
  HeldPlanes(const TriMesh& mesh, const Geometry* grid, const std::vector<Port>& ports);

  /// 0, 1, or 2 where no direction is left along the wall.
  [[nodiscard]] int count(std::uint32_t v) const {
    return (of_[v][0] != none ? 1 : 0) + (of_[v][1] != none ? 1 : 0);
  }
  /// The normal of the (first) plane that a vertex lies in, unit.
  [[nodiscard]] const Eigen::Vector3d& normal(std::uint32_t v) const { return normals_[of_[v][0]]; }
  /// Whether a triangle is part of a cap.
  [[nodiscard]] bool isCap(std::size_t triangle) const { return cap_[triangle] != 0; }
  [[nodiscard]] bool sharePlane(std::uint32_t v, std::uint32_t w) const;

 private:
  static constexpr std::uint16_t none = 0xffffU;

  void holdInBorders(const TriMesh& mesh, const Geometry& grid);
  std::uint16_t planeOf(const Eigen::Vector3d& normal);
  void hold(std::uint32_t v, std::uint16_t plane);

  std::vector<Eigen::Vector3d> normals_;
  std::vector<std::array<std::uint16_t, 2>> of_;  ///< per vertex
  std::vector<char> cap_;                         ///< per triangle
};

}  // namespace angiomesh

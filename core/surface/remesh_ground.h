// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "core/surface/remesh.h"
#include "core/surface/spline_field.h"

namespace angiomesh {

/// Where the vertices of a PatchMesh may lie: the zero set and the border planes of its grid.
class RemeshGround {
 public:
  using Vector3d = Eigen::Vector3d;

  /// Both must outlive the object.
  RemeshGround(const SplineField& field, const EdgeSize& size);

  /// In how many directions a vertex of this place (see PatchMesh) can move: 0, 1 or 2.
  [[nodiscard]] static int freedom(std::uint8_t place);

  /// The part of `step` that a vertex at a point with this normal of the wall can go.
  [[nodiscard]] Vector3d along(std::uint8_t place, const Vector3d& normal,
                               const Vector3d& step) const;

  /// Brings `point` back by at most `steps` Newton steps, until it is within `voxels` of the zero
  /// set, and gives the outward normal (to first order where the steps end first). False where the
  /// gradient vanishes or the point leaves the grid.
  bool land(std::uint8_t place, Vector3d& point, Vector3d& normal, int steps,
            double voxels = 1e-6) const;

  [[nodiscard]] double voxelMm() const { return voxel_; }
  [[nodiscard]] double sizeAt(const Vector3d& point) const { return size_.at(point); }
  [[nodiscard]] const Vector3d& planeNormal(int plane) const {
    return planeNormals_[static_cast<std::size_t>(plane)];
  }

 private:
  [[nodiscard]] static int planes(std::uint8_t place);
  void snap(std::uint8_t place, Vector3d& point) const;

  const SplineField& field_;
  const EdgeSize& size_;
  double voxel_;
  Eigen::Matrix3d toIndex_;
  Eigen::Vector3d last_;
  std::array<Vector3d, 6> planeNormals_;  ///< outward
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/field/spline_field.h"
#include "core/openings/end_planes.h"
#include "core/remesh/remesh.h"

namespace angiomesh {

/// Where the vertices of a PatchMesh may lie: the zero set and the planes that it ends in.
class RemeshGround {
 public:
  using Vector3d = Eigen::Vector3d;

  /// All must outlive the object.
  RemeshGround(const SplineField& field, const EdgeSize& size, const EndPlanes& ends);

  /// The part of `step` that a vertex at a point with this normal of the wall can go.
  [[nodiscard]] Vector3d along(const Place& place, const Vector3d& normal,
                               const Vector3d& step) const;

  /// Brings `point` back by at most `steps` Newton steps, until it is within `voxels` of the zero
  /// set, and gives the outward normal (to first order where the steps end first). False where the
  /// gradient vanishes or the point leaves the grid.
  bool land(const Place& place, Vector3d& point, Vector3d& normal, int steps,
            double voxels = 1e-6) const;

  [[nodiscard]] double voxelMm() const { return voxel_; }
  [[nodiscard]] double sizeAt(const Vector3d& point) const { return size_.at(point); }
  [[nodiscard]] const Vector3d& planeNormal(int plane) const { return ends_.normal(plane); }

 private:
  const SplineField& field_;
  const EdgeSize& size_;
  const EndPlanes& ends_;
  double voxel_;
  Eigen::Matrix3d toIndex_;
  Eigen::Vector3d last_;
};

}  // namespace angiomesh

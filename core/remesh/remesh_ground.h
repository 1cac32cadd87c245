// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/field/spline_field.h"
#include "core/openings/end_planes.h"
#include "core/remesh/remesh.h"

namespace angiomesh {

/// Where the vertices of a mesh may lie, by their places: on a wall, and in the planes that it ends
/// in.
class RemeshGround {
 public:
  using Vector3d = Eigen::Vector3d;

  virtual ~RemeshGround() = default;

  /// The part of `step` that a vertex at a point with this normal of the wall can go.
  [[nodiscard]] Vector3d along(const Place& place, const Vector3d& normal,
                               const Vector3d& step) const;

  /// The part of `step` that lies in the planes of a place.
  [[nodiscard]] virtual Vector3d inPlanes(const Place& place, const Vector3d& step) const = 0;

  /// Brings `point` back by at most `steps` Newton steps, until it is within 1e-6 units of the
  /// wall, and gives the outward normal (to first order where the steps end first). False where
  /// there is no wall to be found.
  virtual bool land(const Place& place, Vector3d& point, Vector3d& normal, int steps) const = 0;

  /// Whether a vertex may go to where the wall has this normal.
  [[nodiscard]] virtual bool allows(std::uint32_t vertex, const Vector3d& normal) const = 0;

  /// The wanted length of edges at a vertex that lies there, mm.
  [[nodiscard]] virtual double sizeAt(std::uint32_t vertex, const Vector3d& point) const = 0;
  /// Outward, unit; planes are numbered as places name them. 0: the vertices keep to a line, in no
  /// plane that is known.
  [[nodiscard]] virtual const Vector3d& planeNormal(int plane) const = 0;
  /// What distances from the wall are compared with, mm.
  [[nodiscard]] virtual double unitMm() const = 0;

 protected:
  RemeshGround() = default;
  RemeshGround(const RemeshGround&) = default;
  RemeshGround& operator=(const RemeshGround&) = default;
};

/// phi = 0 and the planes that it ends in; the unit is the voxel.
class ZeroSetGround final : public RemeshGround {
 public:
  /// All must outlive the object.
  ZeroSetGround(const SplineField& field, const EdgeSize& size, const EndPlanes& ends);

  [[nodiscard]] Vector3d inPlanes(const Place& place, const Vector3d& step) const override {
    return ends_.along(place, step);
  }
  bool land(const Place& place, Vector3d& point, Vector3d& normal, int steps) const override;
  [[nodiscard]] bool allows(std::uint32_t, const Vector3d&) const override { return true; }
  [[nodiscard]] double sizeAt(std::uint32_t, const Vector3d& point) const override {
    return size_.at(point);
  }
  [[nodiscard]] const Vector3d& planeNormal(int plane) const override {
    return ends_.normal(plane);
  }
  [[nodiscard]] double unitMm() const override { return voxel_; }

 private:
  const SplineField& field_;
  const EdgeSize& size_;
  const EndPlanes& ends_;
  double voxel_;
  Eigen::Matrix3d toIndex_;
  Eigen::Vector3d last_;
};

}  // namespace angiomesh

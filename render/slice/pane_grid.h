// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/image/volume.h"
#include "render/slice/pane_axes.h"

namespace angiomesh {

/// How the three slice planes lie. Each is turned from where it began, by rotations of patient
/// space; together they stay at right angles.
struct PlaneTurn {
  bool patientAxes = false;  ///< they begin along the patient's axes, not along the image's
  std::array<Eigen::Matrix3d, 3> turns{Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity(),
                                       Eigen::Matrix3d::Identity()};
  Eigen::Vector3d pivotLps{0.0, 0.0, 0.0};  ///< lies in a slice of each turned plane

  [[nodiscard]] bool turned(int plane) const;
  [[nodiscard]] bool turned() const;
  /// The planes but `about` turned by an angle about an axis of unit length through `pivot`, which
  /// is the normal of that one.
  [[nodiscard]] PlaneTurn turnedBy(int about, double radians, const Eigen::Vector3d& axis,
                                   const Eigen::Vector3d& pivot) const;
  bool operator==(const PlaneTurn&) const = default;
};

/// The slices of a pane as those of a grid: the image's own, or one of cubes that covers it.
struct PaneGrid {
  Geometry grid;
  PaneAxes axes;           ///< in the grid
  double turnedDeg = 0.0;  ///< of the normal, from where it began
  bool native = true;      ///< the grid is the image's
};
PaneGrid paneGrid(const Geometry& image, int plane, const PlaneTurn& turn);

/// Normals of the three planes, unit, mm LPS.
std::array<Eigen::Vector3d, 3> planeNormals(const Geometry& image, const PlaneTurn& turn);

}  // namespace angiomesh

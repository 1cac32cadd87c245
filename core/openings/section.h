// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/field/spline_field.h"
#include "core/openings/end_planes.h"

namespace angiomesh {

/// The part of a plane inside phi < 0 that is connected, within the plane, to one of its points: a
/// slice through one vessel, whatever else the plane meets.
struct Section {
  CutPlane plane;
  /// Its outline: closed polylines on phi = 0, the inside to the right seen from outside (against
  /// the normal).
  std::vector<std::vector<Eigen::Vector3d>> loops;
  double areaMm2 = 0.0;
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of the area
  double radiusMm = 0.0;                     ///< from the centre to the farthest of the outline

  /// Signed distance from the plane, mm, positive outside.
  [[nodiscard]] double height(const Eigen::Vector3d& pointLps) const {
    return (pointLps - plane.pointLps).dot(plane.normalLps);
  }
  /// Whether a point near the plane lies over the section or, `mm` from it, beside it; to a lattice
  /// step.
  [[nodiscard]] bool covers(const Eigen::Vector3d& pointLps, double mm = 0.0) const;
  [[nodiscard]] double equivalentDiameterMm() const;
  /// Else it slants through its vessel, or lies in a branching.
  [[nodiscard]] bool isAboutRound() const;

  /// The voxels, first and last, within a distance of its rim and of what lies inside it.
  [[nodiscard]] std::array<Index3, 2> voxelsAround(const Geometry& grid, double mm) const;

  /// The lattice that it was found on: node (i, j) at origin + i u + j v.
  struct Lattice {
    Eigen::Vector3d origin{0.0, 0.0, 0.0}, u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};
    int columns = 0, rows = 0;
    std::vector<char> inside;  ///< per node, columns fastest: it belongs to the section
  } lattice;
};

/// By marching squares on a lattice of `finer` steps per working voxel; area and centre to fourth
/// order of the step. `name` is for messages: "the cut" unless given.
/// @throws InputError when the point is not inside phi < 0, or the section reaches the outermost
/// voxel centres
Section sectionOf(const SplineField& field, const CutPlane& plane, const std::string& name = {},
                  int finer = 4);

}  // namespace angiomesh

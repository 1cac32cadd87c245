// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "core/phantom/phantom.h"

namespace angiomesh {

class ShapeIndex;

/// The place of the true wall that is nearest to a point.
struct WallFoot {
  Eigen::Vector3d point;          ///< on the wall, LPS mm
  Eigen::Vector3d normal;         ///< of the wall there, of length 1, outwards
  double signedDistanceMm = 0.0;  ///< of the point asked for, positive outside
};

/// Principal curvatures, 1/mm, positive where the wall is convex seen from outside: 1/r both on a
/// ball, 1/r and 0 on a tube.
struct WallCurvature {
  double largest = 0.0, least = 0.0;
  [[nodiscard]] double mean() const { return 0.5 * (largest + least); }
};

/// Where three vessels and more meet, or one begins on another's side.
struct Branching {
  Eigen::Vector3d point;  ///< LPS mm
  double radiusMm = 0.0;  ///< of the thickest vessel there
};

/// The narrowest place of a stenosis.
struct Throat {
  Eigen::Vector3d centre, axis;  ///< LPS mm; of length 1
  double radiusMm = 0.0, halfLengthMm = 0.0;
};

/// The wall that a phantom is made from, exactly. May be asked from several threads.
class WallTruth {
 public:
  /// @throws InputError for parameters that cannot be met
  explicit WallTruth(const PhantomParams& params);

  /// By Newton's method on the shape's implicit function, whose value is no distance where solids
  /// blend (to 1e-9 voxel at distances below half the radius of curvature); gradients are central
  /// differences over 2e-4 voxel.
  [[nodiscard]] WallFoot footOf(const Eigen::Vector3d& pointLps) const;

  /// From central second differences with a step of 0.02 voxel in the wall's tangent plane.
  [[nodiscard]] WallCurvature curvatureAt(const WallFoot& foot) const;

  /// Of the centre line whose wall is nearest, mm.
  [[nodiscard]] double radiusAt(const Eigen::Vector3d& pointLps) const;

  /// Whether a point is within `share` of a branching's radius of the ball of that radius around
  /// the branching.
  [[nodiscard]] bool nearBranching(const Eigen::Vector3d& pointLps, double share = 0.75) const;

  [[nodiscard]] const Geometry& grid() const { return grid_; }  ///< of the phantom's voxels
  [[nodiscard]] const std::vector<Branching>& branchings() const { return branchings_; }
  [[nodiscard]] const std::optional<Throat>& throat() const { return throat_; }

 private:
  [[nodiscard]] Eigen::Vector3d gradientAt(const Eigen::Vector3d& point) const;

  Geometry grid_;
  std::shared_ptr<const ShapeIndex> shape_;
  std::vector<CentreLineSegment> centreLines_;
  std::vector<Branching> branchings_;
  std::optional<Throat> throat_;
};

/// The radius of the centre line whose wall is nearest to a point, mm; 0 without centre lines.
double nearestVesselRadius(const std::vector<CentreLineSegment>& lines,
                           const Eigen::Vector3d& point);

}  // namespace angiomesh

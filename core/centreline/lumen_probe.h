// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/field/spline_field.h"

namespace angiomesh {

/// The part of a plane inside a vessel.
struct LumenSection {
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of its area
  double radiusMm = 0.0;                     ///< sqrt(area / pi)
  double inscribedMm = 0.0;                  ///< from the centre to the nearest wall in the plane
  double cutShare = 0.0;  ///< of the directions in which the volume ends before the vessel
};

/// Looks from points inside a vessel at its wall: along rays, which tell the distance also where
/// phi is clamped. Keeps a reference to phi, a signed distance in mm, negative inside.
class LumenProbe {
 public:
  explicit LumenProbe(const SplineField& phi);

  enum class End { Wall, Border };
  struct Ray {
    Eigen::Vector3d direction;  ///< unit
    double lengthMm = 0.0;
    End end = End::Wall;  ///< Border: it leaves the box of the voxels' centres
  };

  /// From `from`, phi < 0 there, to where phi is no more negative, to within 1e-3 voxel.
  [[nodiscard]] Ray cast(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;

  /// In many directions, evenly spread.
  [[nodiscard]] std::vector<Ray> castAround(const Eigen::Vector3d& from) const;

  /// The section around `point` perpendicular to the unit vector `axis`, from rays in the plane,
  /// begun anew at its centre until that stays. What is seen in one direction alone, into a branch
  /// or through a thin bridge, counts as far as the other directions let expect. Nothing where phi
  /// >= 0 and outside the volume.
  [[nodiscard]] std::optional<LumenSection> section(const Eigen::Vector3d& point,
                                                    const Eigen::Vector3d& axis) const;

  /// Outward unit normal of the level set; 0 where phi is flat.
  [[nodiscard]] Eigen::Vector3d normalAt(const Eigen::Vector3d& point) const;

  [[nodiscard]] bool isInside(const Eigen::Vector3d& point) const {
    return phi_.valueAt(point) < 0.0;
  }
  /// Moves a point into the box of the voxels' centres.
  [[nodiscard]] Eigen::Vector3d intoVolume(const Eigen::Vector3d& point) const;
  /// How far along `direction` the box of the voxels' centres goes.
  [[nodiscard]] double toBorder(const Eigen::Vector3d& from,
                                const Eigen::Vector3d& direction) const;

  [[nodiscard]] const SplineField& phi() const { return phi_; }
  [[nodiscard]] double voxelMm() const { return voxelMm_; }

 private:
  const SplineField& phi_;
  double voxelMm_;
  Eigen::Matrix3d toIndex_;
  std::vector<Eigen::Vector3d> around_;
};

/// Two unit vectors that with `axis` make a right-handed frame.
struct Plane {
  Eigen::Vector3d u, v;
  explicit Plane(const Eigen::Vector3d& axis);
};

}  // namespace angiomesh

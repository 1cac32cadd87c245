// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/field/spline_field.h"

namespace angiomesh {

/// The vessel around a place.
struct LocalVessel {
  Eigen::Vector3d axisLps{0.0, 0.0, 1.0};  ///< unit, its greatest component positive
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};
  double radiusMm = 0.0;     ///< sqrt(area / pi) of the section perpendicular to the axis
  double inscribedMm = 0.0;  ///< from the centre to the nearest wall in the section

  /// The axis in its sense that goes along with a direction.
  [[nodiscard]] Eigen::Vector3d axisAlong(const Eigen::Vector3d& direction) const;
  /// The way onwards from here after one that came so far: that of the axis, but straight on where
  /// the axis is so far off that it is another vessel's.
  [[nodiscard]] Eigen::Vector3d wayOn(const Eigen::Vector3d& ahead) const;
};

/// The vessel at a point in LPS mm that lies inside it or at most `reachVoxels` working voxels off
/// its wall; nothing elsewhere.
///
/// The nearest wall point's maximal inscribed ball (Ma, Bae & Choi 2012, "3D medial axis point
/// approximation using nearest neighbors and the normal field") gives a first centre. Seen from
/// there, the axis is the direction that the normals of the wall around avoid: the least
/// eigenvector of their structure matrix, near walls counting most. Centre of the section and axis
/// then improve each other. phi may be clamped, at +-2 working voxels or more.
std::optional<LocalVessel> vesselAt(const SplineField& phi, const Eigen::Vector3d& pointLps,
                                    double reachVoxels = 2.0);

}  // namespace angiomesh

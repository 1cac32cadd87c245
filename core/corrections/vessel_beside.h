// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/image/volume.h"

namespace angiomesh {

/// A place of a segmentation as somebody points at it.
struct VesselBeside {
  Index3 voxel{0, 0, 0};                     ///< in phi < 0, the nearest one to the place
  Index3 middle{0, 0, 0};                    ///< uphill from there: where the wall is farthest
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of the vessel's section there, mm
  double radiusMm = 0.0;                     ///< of that section
  double ballMm = 0.0;                       ///< of the largest ball around `middle`
};

/// The vessel at a place in mm LPS, or at most `reachVoxels` working voxels beside it.
std::optional<VesselBeside> vesselBeside(const Volume<float>& phi, const Eigen::Vector3d& placeLps,
                                         double reachVoxels = 3.0);

/// The same. @throws InputError from `where` with `advice` where there is none
VesselBeside requireVesselBeside(const Volume<float>& phi, const Eigen::Vector3d& placeLps,
                                 const char* where, const char* advice);

}  // namespace angiomesh

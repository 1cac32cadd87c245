// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// Which handles are taken for errors of the wall's place.
struct HandleLimits {
  double depth = 0.5;          ///< how far the wall may be wrong, in the unit of phi
  std::size_t holeVoxels = 9;  ///< a hole of more voxels across stays
  double loopVoxels = 12.0;    ///< a handle with a longer loop is not cut
  std::size_t cutVoxels = 9;   ///< nor one of more voxels across
};

/// What was done about one handle or cavity.
struct HandleChange {
  bool filled = false;                      ///< a hole or a cavity; else a handle was cut
  Eigen::Vector3d placeLps{0.0, 0.0, 0.0};  ///< the middle of the voxels that changed sides, mm
  std::size_t voxels = 0;                   ///< how many did
  double depth = 0.0;  ///< the largest |phi| among those that had to, in the unit of phi
};

/// Fills holes through the vessels phi < 0 (26-connected) and small cavities, and cuts handles,
/// where that takes moving phi by no more than the limit: what is there at phi < -t or at phi < t
/// but not at phi < 0, for growing t, so that the cheaper change comes first. All in phi order by
/// voxels that change no other topology; no parts appear, vanish or are joined. phi changes sign at
/// the voxels of the changes alone. The same for any number of threads.
/// @param uncertainty of the wall's place at each voxel, in the unit of phi, on the same grid;
/// null: limits.depth everywhere   @throws Cancelled
std::vector<HandleChange> closeSmallHandles(Volume<float>& phi, const HandleLimits& limits,
                                            const Volume<float>* uncertainty = nullptr,
                                            const Progress& progress = {});

}  // namespace angiomesh

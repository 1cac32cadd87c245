// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/skeleton.h"
#include "core/image/volume.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// The wall of a segmentation, where others are compared with it.
struct WallPlaces {
  TriMesh wall;       ///< marching cubes, without caps; its vertices are the places
  Skeleton skeleton;  ///< of the same vessels
  /// Of the field through phi at each vertex, mm: marching cubes leaves them a little off.
  std::vector<float> off;
  std::vector<std::int32_t> branch;  ///< of each vertex, of the skeleton; -1 where there is none
};

/// @param phi signed distance, mm, clamped at 5 working voxels   @throws Cancelled
WallPlaces wallPlaces(const Volume<float>& phi, const Progress& progress = {});

/// How the wall of another segmentation lies to it.
struct WallMoves {
  /// Outwards positive, mm, at each place; at most 4 working voxels either way. A vessel that is
  /// lost has moved in by that, and counts for no mean.
  std::vector<float> movedMm;
  double meanMm = 0.0;          ///< outwards
  double meanSizeMm = 0.0;      ///< of their absolute values
  double p95Mm = 0.0;           ///< likewise, 95th percentile
  double lostPercent = 0.0;     ///< of the places
  double volumePercent = 0.0;   ///< that the vessels have more, by voxels
  double overlapPercent = 0.0;  ///< Dice's, of voxels
  struct Branch {
    std::size_t places = 0;
    double meanMm = 0.0;  ///< outwards: by how much the mean radius is larger
    double lostPercent = 0.0;
  };
  std::vector<Branch> branches;  ///< of the skeleton
};

/// The mean over each branch is that of its places. @pre both phi on one grid
WallMoves wallMoves(const WallPlaces& places, const Volume<float>& phi, const Volume<float>& other);

}  // namespace angiomesh

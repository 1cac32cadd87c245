// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/image/volume.h"

namespace angiomesh {

struct SkeletonPoint {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};  ///< mm
  double radiusMm = 0.0;     ///< sqrt(area / pi) of the section; inside a junction that beside it
  double inscribedMm = 0.0;  ///< from the section's centre to the nearest wall in it
};

/// Tip: where a vessel ends inside the volume, at the centre of the last ball that fits. Border:
/// where it leaves the box of the voxels' centres. Ring: anywhere on a ring without junctions.
enum class NodeKind { Tip, Junction, Border, Ring };

struct SkeletonNode {
  NodeKind kind = NodeKind::Tip;
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};
  int component = 0;      ///< from 1, see connectedComponents()
  double radiusMm = 0.0;  ///< of the thickest branch that ends here
};

/// The centre line of a vessel from node to node.
struct SkeletonBranch {
  int from = 0, to = 0;               ///< nodes; the same one where a ring closes
  int component = 0;                  ///< from 1, see connectedComponents()
  std::vector<SkeletonPoint> points;  ///< two or more, about a working voxel apart
  double lengthMm = 0.0;
  /// Of the points outside the junctions, where there are any.
  double meanRadiusMm = 0.0, minRadiusMm = 0.0, maxRadiusMm = 0.0;
};

struct Skeleton {
  std::vector<SkeletonNode> nodes;
  /// By component, the largest first; of a component that is not longer than it is thick none.
  std::vector<SkeletonBranch> branches;
};

/// The centre lines of the vessels phi < 0: those of CentreLines, split where they meet, each point
/// moved to the centre of the section perpendicular to its branch. A junction lies where the lines
/// of its branches come closest to each other; in it, within the reach of the vessels that meet, a
/// branch goes straight on to that place. The same for any number of threads.
/// @param phi signed distance in mm, negative inside, clamped at 5 working voxels or more
Skeleton skeletonOf(const Volume<float>& phi, const Progress& progress = {});

/// A place on a skeleton.
struct SkeletonPlace {
  int branch = 0;
  int point = 0;  ///< of the branch, the nearest
};

/// The place nearest to a point that is seen from there through the inside of the vessel, or, of a
/// point up to 2 working voxels off a wall, from the centre of that vessel. Nothing farther off,
/// and in parts without branches.
std::optional<SkeletonPlace> placeOnSkeleton(const Skeleton& skeleton, const SplineField& phi,
                                             const Eigen::Vector3d& pointLps);

}  // namespace angiomesh

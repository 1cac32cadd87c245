// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {

/// How far from each triangle the wall is again, straight from its centroid along its normal.
/// Triangles with a corner in common with it do not count. Not a number where there is no wall, the
/// triangle has no area, or it is of a cap: beside a rim the way through a cap is as short as one
/// likes.
struct WallGaps {
  /// Outwards, in mean edges of the triangle; not a number beyond gapReach of these.
  std::vector<float> gapEdges;
  std::vector<float> thicknessMm;  ///< inwards, through the vessel
};
/// Gaps wider than this are wide enough for any mesh between.
inline constexpr double gapReach = 3.0;

WallGaps measureGaps(const TriMesh& mesh, const Progress& progress = {});
WallGaps measureGaps(const TriMesh& mesh, const TriangleTree& tree, const Progress& progress);

/// What they come to.
struct GapFigures {
  std::optional<double> leastGapEdges;  ///< where there is a gap within reach
  double narrowPercent = 0.0;           ///< of the triangles: the gap is shorter than their edges
  std::optional<double> leastThicknessMm, thickness1Mm;  ///< least, and 1st percentile
};
GapFigures gapFigures(const WallGaps& gaps);

}  // namespace angiomesh

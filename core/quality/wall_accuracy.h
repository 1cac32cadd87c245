// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "core/phantom/wall_truth.h"

namespace angiomesh {

/// How a mesh lies on the true wall. Distances and angles are NaN without a vertex or triangle.
struct WallAgreement {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::size_t vertices = 0, triangles = 0;  ///< that count
  double meanMm = kNone;                    ///< signed distance of the vertices, positive outside
  double spreadMm = kNone;                  ///< its standard deviation
  double distance95Mm = kNone;              ///< 95th percentile of the absolute distance
  double normalMeanDeg = kNone;  ///< triangle's normal to the wall's at the centroid's foot
  double normal95Deg = kNone;
  /// Median of |H - H'| / max(|H'|, 1 / 4r): H' the true mean curvature at the vertex' foot, r the
  /// vessel's radius there, H that of a quadratic height (LocalWall, a graph) over the vertex'
  /// normal fitted to its two rings. 1 / 2r is a tube's; where the wall is saddle-shaped H' may be
  /// 0.
  double curvatureErrorMedian = kNone;
};

/// Classes of the vessels' radius, voxels: [1.3, 2), [2, 4), [4, 5), from 5 on.
constexpr std::array<double, 5> kRadiusClasses{1.3, 2.0, 4.0, 5.0, 1e9};

/// Of a stenosis: diameters of circles with the area of the narrowest cross-section.
struct StenosisDiameter {
  double trueMm = 0.0, foundMm = 0.0;
  [[nodiscard]] double errorPercent() const { return 100.0 * (foundMm / trueMm - 1.0); }
};

struct WallAccuracy {
  WallAgreement all;
  std::array<WallAgreement, kRadiusClasses.size() - 1> byRadius;
  std::size_t leftOut = 0;  ///< wall vertices that do not count
  std::optional<StenosisDiameter> stenosis;
};

/// Measures the wall of a mesh against the true one. What does not count: patches and caps,
/// places within 0.75 radius of a branching (WallTruth::nearBranching, of the foot), and what lies
/// within 1.25 voxels of the plane of outermost voxel centres or beyond it.
/// @throws InputError (see checkMesh), Cancelled
WallAccuracy wallAccuracy(const TriMesh& mesh, const WallTruth& truth,
                          const Progress& progress = {});

/// The least diameter across a throat: of the circles with the area of the mesh's cross-sections
/// perpendicular to its axis, in planes a twentieth of a voxel apart along half of the narrowing;
/// 0 where the vessel is cut through, nothing where the mesh does not reach.
std::optional<double> leastDiameter(const TriMesh& mesh, const Throat& throat, double voxelMm);

}  // namespace angiomesh

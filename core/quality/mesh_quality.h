// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/mesh/tri_mesh.h"
#include "core/mesh/triangle_shape.h"
#include "core/quality/neighbours.h"
#include "core/quality/roughness.h"
#include "core/quality/wall_gaps.h"

namespace angiomesh {

/// Distances to a reference, mm.
struct DeviationStats {
  double meanMm = 0.0;
  double p99Mm = 0.0;
  double maxMm = 0.0;
};

/// Distances times the largest curvature of the wall at the foot, as pure numbers: those of an
/// inscribed triangle do not depend on how fine the mesh is made for its curvature.
struct CurvedDeviation {
  double mean = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

/// Triangles in corners where the surface's own outline leaves no choice: two of their sides border
/// two other patches, as where a rim meets an edge of the volume. And what the others come to.
struct CornerShapes {
  std::size_t triangles = 0;
  double minAngle = 180.0, maxAngle = 0.0, radiusRatio = 1.0;  ///< the worst in such corners
  double otherMinAngle = 180.0, otherMaxAngle = 0.0, otherRadiusRatio = 1.0;  ///< elsewhere
};

/// What a mesh is worth to a solver; the fields of `mesh` in report.json, same meanings and units.
struct MeshQuality {
  std::size_t vertices = 0, triangles = 0;
  int components = 0;  ///< edge-connected faces
  std::size_t boundaryEdges = 0, boundaryLoops = 0;
  std::size_t nonManifoldEdges = 0;     ///< edges of more than two triangles
  std::size_t nonManifoldVertices = 0;  ///< vertices whose triangles are not one fan
  std::size_t degenerateTriangles = 0;  ///< exactly collinear or repeated corners
  std::size_t selfIntersections =
      0;  ///< pairs of triangles that meet outside shared corners and edges (exact)
  int euler = 0;
  int genus = 0;  ///< sum over components, from euler = sum of 2 - 2g - b
  bool closed = false, oriented = false;
  /// Whether it encloses a volume: what is not oriented has none, whatever volumeMm3 says.
  [[nodiscard]] bool hasVolume() const { return closed && oriented; }
  double areaMm2 = 0.0, volumeMm3 = 0.0;
  double minAngleMin = 0.0, minAngleP01 = 0.0,
         minAngleMean = 0.0;  ///< smallest angle of each triangle, degrees
  double maxAngleMax = 0.0, maxAngleP99 = 0.0;
  double radiusRatioMin = 0.0, radiusRatioP01 = 0.0,
         radiusRatioMean = 0.0;  ///< 2 r / R, 1 is equilateral
  /// Equiangular skewness, max((largest - 60) / 120, (60 - smallest) / 60) of the angles in
  /// degrees: 0 is equilateral, 1 has no area.
  double skewnessMax = 0.0, skewnessMean = 0.0;
  double aspectMax = 0.0, aspectMean = 0.0;  ///< see TriangleShape; infinite where one has no area
  std::optional<Valences> valences;
  std::optional<double> gradationMax, gradationP99;  ///< see sizeGradations()
  GapFigures gaps;
  std::optional<CornerShapes> corners;  ///< where there are such triangles
  double edgeMinMm = 0.0, edgeMeanMm = 0.0, edgeMaxMm = 0.0;
  double below20Percent = 0.0, below30Percent = 0.0;  ///< of triangles, by smallest angle
  std::optional<DeviationStats> vertexDeviation,
      centroidDeviation;  ///< from the zero set of phi, where given
  std::optional<CurvedDeviation> centroidTimesCurvature;
  std::optional<Roughness> roughness;  ///< of the wall; empty where too few vertices tell
  /// Share of the triangles that come from the advancing front, where it made the mesh.
  std::optional<double> fromFrontPercent;
  /// Up to 1000 intersecting pairs of triangles, for the inspector.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> intersectingPairs;
};

/// Deviation is the length of the projection onto the zero set of `phi` (Newton to 1e-6 voxel).
/// @param meetsNothing somebody has seen that no triangles meet: nobody looks again
MeshQuality measureQuality(const TriMesh& mesh, const SplineField* phi = nullptr,
                           const Progress& progress = {}, bool meetsNothing = false);

/// Of every triangle; those of repeated or exactly collinear corners are without area.
std::vector<TriangleShape> shapesOf(const TriMesh& mesh);

/// "the surface cuts itself in ...", as text() has it, empty where it has no fault. `known`, where
/// not null, is the mesh's quality, which may tell that at once. @throws Cancelled
std::string surfaceFault(const TriMesh& mesh, bool closed, const MeshQuality* known = nullptr,
                         const Progress& progress = {});

}  // namespace angiomesh

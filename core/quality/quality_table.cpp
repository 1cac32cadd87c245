// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/quality_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace angiomesh {
namespace {

using Q = MeshQuality;
using Value = std::optional<double>;

template <auto member>
Value number(const Q& q) {
  return static_cast<double>(q.*member);
}

/// Of the triangles, where there are any.
template <auto member>
Value shape(const Q& q) {
  return q.triangles > 0 ? Value(q.*member) : Value();
}

template <auto block, auto member>
Value within(const Q& q) {
  return q.*block ? Value(static_cast<double>((*(q.*block)).*member)) : Value();
}

Value volume(const Q& q) {
  // That of an open surface would depend on where the origin lies.
  return q.hasVolume() ? Value(q.volumeMm3) : Value();
}

template <auto member>
Value own(const Q& q) {
  return q.*member;
}

/// A triangle without area has no aspect ratio that could be written.
template <auto member>
Value aspect(const Q& q) {
  return q.triangles > 0 && std::isfinite(q.*member) ? Value(q.*member) : Value();
}

template <auto member>
Value gap(const Q& q) {
  return q.gaps.*member;
}

Value narrow(const Q& q) { return q.gaps.leastGapEdges ? Value(q.gaps.narrowPercent) : Value(); }

Value fromFront(const Q& q) { return q.fromFrontPercent; }

/// No mesher chooses the shapes in corners of the outline.
template <auto elsewhere, auto all>
Value outsideCorners(const Q& q) {
  return q.corners ? Value((*q.corners).*elsewhere) : shape<all>(q);
}

}  // namespace

const std::vector<QualityMeasure>& qualityMeasures() {
  using K = MeasureKind;
  using B = Better;
  using C = CornerShapes;
  using D = DeviationStats;
  using F = CurvedDeviation;
  static const std::vector<QualityMeasure> table{
      {"vertices", "Vertices", "", K::Count, 0, false, B::Neither, "points that triangles use",
       number<&Q::vertices>},
      {"triangles", "Triangles", "", K::Count, 0, true, B::Neither, "", number<&Q::triangles>},
      {"components", "Components", "", K::Count, 0, true, B::Neither,
       "edge-connected sets of triangles", number<&Q::components>},
      {"boundary_edges", "Boundary edges", "", K::Count, 0, false, B::Less, "of open rims",
       number<&Q::boundaryEdges>},
      {"boundary_loops", "Boundary loops", "", K::Count, 0, false, B::Less, "open rims",
       number<&Q::boundaryLoops>},
      {"non_manifold_edges", "Non-manifold edges", "", K::Count, 0, true, B::Less,
       "edges of more than two triangles", number<&Q::nonManifoldEdges>},
      {"non_manifold_vertices", "Non-manifold vertices", "", K::Count, 0, true, B::Less,
       "vertices whose triangles do not form a single fan", number<&Q::nonManifoldVertices>},
      {"degenerate_triangles", "Degenerate triangles", "", K::Count, 0, true, B::Less,
       "exactly collinear or repeated corners", number<&Q::degenerateTriangles>},
      {"self_intersections", "Self-intersections", "", K::Count, 0, true, B::Less,
       "pairs of triangles that meet outside shared corners and edges, by exact predicates",
       number<&Q::selfIntersections>},
      {"euler", "Euler number", "", K::Count, 0, false, B::Neither, "sum of 2 - 2 genus - rims",
       number<&Q::euler>},
      {"genus", "Genus", "", K::Count, 0, true, B::Neither, "sum over the components",
       number<&Q::genus>},
      {"closed", "Closed", "", K::YesNo, 0, true, B::More, "no boundary edge", number<&Q::closed>},
      {"oriented", "Oriented", "", K::YesNo, 0, true, B::More, "neighbours agree on the outside",
       number<&Q::oriented>},
      {"area_mm2", "Area", "mm2", K::Significant, 6, true, B::Neither, "", number<&Q::areaMm2>},
      {"volume_mm3", "Volume", "mm3", K::Significant, 6, true, B::Neither,
       "by the divergence theorem, positive for outward faces; absent if not closed and oriented",
       volume},
      {"min_angle_deg.min", "Least angle", "deg", K::Fixed, 2, true, B::More,
       "the smallest of all angles; gates leave out corners of the outline", shape<&Q::minAngleMin>,
       outsideCorners<&C::otherMinAngle, &Q::minAngleMin>},
      {"min_angle_deg.p01", "Min angle, 1 %", "deg", K::Fixed, 2, true, B::More,
       "1st percentile of the smallest angle of each triangle", shape<&Q::minAngleP01>},
      {"min_angle_deg.mean", "Min angle, mean", "deg", K::Fixed, 2, true, B::More, "",
       shape<&Q::minAngleMean>},
      {"max_angle_deg.max", "Largest angle", "deg", K::Fixed, 2, true, B::Less, "",
       shape<&Q::maxAngleMax>, outsideCorners<&C::otherMaxAngle, &Q::maxAngleMax>},
      {"max_angle_deg.p99", "Max angle, 99 %", "deg", K::Fixed, 2, false, B::Less,
       "99th percentile of the largest angle of each triangle", shape<&Q::maxAngleP99>},
      {"radius_ratio.min", "Least radius ratio", "", K::Fixed, 3, true, B::More,
       "2 * inradius / circumradius; 1 is equilateral", shape<&Q::radiusRatioMin>,
       outsideCorners<&C::otherRadiusRatio, &Q::radiusRatioMin>},
      {"radius_ratio.p01", "Radius ratio, 1 %", "", K::Fixed, 3, false, B::More, "1st percentile",
       shape<&Q::radiusRatioP01>},
      {"radius_ratio.mean", "Radius ratio, mean", "", K::Fixed, 4, true, B::More, "",
       shape<&Q::radiusRatioMean>},
      {"skewness.max", "Skewness, most", "", K::Fixed, 3, true, B::Less,
       "equiangular skewness, as in Fluent: max((largest angle - 60) / 120, (60 - smallest) / 60); "
       "0 "
       "is equilateral, 1 has no area",
       shape<&Q::skewnessMax>},
      {"skewness.mean", "Skewness, mean", "", K::Fixed, 3, false, B::Less, "",
       shape<&Q::skewnessMean>},
      {"aspect_ratio.max", "Aspect ratio, most", "", K::Significant, 4, true, B::Less,
       "longest edge / (inradius * 12^0.5); 1 is equilateral", aspect<&Q::aspectMax>},
      {"aspect_ratio.mean", "Aspect ratio, mean", "", K::Significant, 4, false, B::Less, "",
       aspect<&Q::aspectMean>},
      {"valence.min", "Valence, least", "", K::Count, 0, false, B::Neither,
       "triangles at a vertex, open rims apart; 6 in an even mesh",
       within<&Q::valences, &Valences::least>},
      {"valence.max", "Valence, most", "", K::Count, 0, false, B::Neither, "",
       within<&Q::valences, &Valences::most>},
      {"valence.regular_percent", "Valence 5 to 7", "%", K::Fixed, 2, true, B::More,
       "of the vertices, open rims apart", within<&Q::valences, &Valences::regularPercent>},
      {"gradation.max", "Gradation, most", "", K::Fixed, 3, true, B::Less,
       "mean edge of a triangle over that of a neighbour, the larger over the smaller one; 1 is "
       "even",
       own<&Q::gradationMax>},
      {"gradation.p99", "Gradation, 99 %", "", K::Fixed, 3, false, B::Less, "",
       own<&Q::gradationP99>},
      {"gap.least_edges", "Thinnest gap", "edges", K::Fixed, 3, true, B::More,
       "from the centroid of a triangle straight outwards to the wall again, in mean edges of the "
       "triangle; absent if none is below 3",
       gap<&GapFigures::leastGapEdges>},
      {"gap.narrow_percent", "Gaps below an edge", "%", K::Fixed, 3, false, B::Less,
       "of the triangles: tetrahedra between the walls would be flat", narrow},
      {"thickness_mm.min", "Thinnest part", "mm", K::Significant, 3, true, B::Neither,
       "from the centroid of a triangle straight inwards to the other side, caps apart; beside a "
       "sharp edge it is short",
       gap<&GapFigures::leastThicknessMm>},
      {"thickness_mm.p01", "Thickness, 1 %", "mm", K::Significant, 3, false, B::Neither,
       "1st percentile", gap<&GapFigures::thickness1Mm>},
      {"corners.triangles", "Corner triangles", "", K::Count, 0, false, B::Neither,
       "those with two sides on the borders of two other patches, whose angles no mesher chooses; "
       "absent if there are none",
       within<&Q::corners, &C::triangles>},
      {"corners.min_angle_deg", "Min angle, corners", "deg", K::Fixed, 2, false, B::More,
       "in such triangles", within<&Q::corners, &C::minAngle>},
      {"corners.max_angle_deg", "Max angle, corners", "deg", K::Fixed, 2, false, B::Less, "",
       within<&Q::corners, &C::maxAngle>},
      {"corners.radius_ratio", "Min ratio, corners", "", K::Fixed, 3, false, B::More, "",
       within<&Q::corners, &C::radiusRatio>},
      {"corners.elsewhere.min_angle_deg", "Min angle, others", "deg", K::Fixed, 2, false, B::More,
       "in all others", within<&Q::corners, &C::otherMinAngle>},
      {"corners.elsewhere.max_angle_deg", "Max angle, others", "deg", K::Fixed, 2, false, B::Less,
       "", within<&Q::corners, &C::otherMaxAngle>},
      {"corners.elsewhere.radius_ratio", "Min ratio, others", "", K::Fixed, 3, false, B::More, "",
       within<&Q::corners, &C::otherRadiusRatio>},
      {"edge_length_mm.min", "Shortest edge", "mm", K::Significant, 4, false, B::Neither, "",
       shape<&Q::edgeMinMm>},
      {"edge_length_mm.mean", "Edge, mean", "mm", K::Significant, 4, true, B::Neither, "",
       shape<&Q::edgeMeanMm>},
      {"edge_length_mm.max", "Longest edge", "mm", K::Significant, 4, false, B::Neither, "",
       shape<&Q::edgeMaxMm>},
      {"below_20_deg_percent", "Below 20 deg", "%", K::Fixed, 3, true, B::Less,
       "of the triangles, by smallest angle", shape<&Q::below20Percent>},
      {"below_30_deg_percent", "Below 30 deg", "%", K::Fixed, 3, true, B::Less,
       "of the triangles, by smallest angle", shape<&Q::below30Percent>},
      {"roughness.spread_mm", "Roughness", "mm", K::Significant, 3, true, B::Less,
       "median of the vertices' root mean square distance from a smooth fit around them, see "
       "report.md",
       within<&Q::roughness, &Roughness::spreadMm>},
      {"roughness.spread_p95_mm", "Roughness, 95 %", "mm", K::Significant, 3, false, B::Less,
       "its 95th percentile; branchings and tips raise it",
       within<&Q::roughness, &Roughness::spread95Mm>},
      {"roughness.angle_deg", "Roughness, angle", "deg", K::Fixed, 2, true, B::Less,
       "median of the angle between neighbouring triangles that neither their size nor the "
       "curvature "
       "of the wall explains",
       within<&Q::roughness, &Roughness::angleDeg>},
      {"from_front_percent", "From the front", "%", K::Fixed, 2, true, B::Neither,
       "share of the triangles that the advancing front made; absent for other methods", fromFront},
      {"deviation.vertex.mean_mm", "Vertex off, mean", "mm", K::Significant, 3, false, B::Less,
       "distance from the zero set of the interpolant that was meshed, caps apart",
       within<&Q::vertexDeviation, &D::meanMm>},
      {"deviation.vertex.p99_mm", "Vertex off, 99 %", "mm", K::Significant, 3, false, B::Less, "",
       within<&Q::vertexDeviation, &D::p99Mm>},
      {"deviation.vertex.max_mm", "Vertex off, most", "mm", K::Significant, 4, true, B::Less, "",
       within<&Q::vertexDeviation, &D::maxMm>},
      {"deviation.centroid.mean_mm", "Centroid off, mean", "mm", K::Significant, 3, true, B::Less,
       "the same of the centroids of the triangles", within<&Q::centroidDeviation, &D::meanMm>},
      {"deviation.centroid.p99_mm", "Centroid off, 99 %", "mm", K::Significant, 3, false, B::Less,
       "", within<&Q::centroidDeviation, &D::p99Mm>},
      {"deviation.centroid.max_mm", "Centroid off, most", "mm", K::Significant, 4, true, B::Less,
       "", within<&Q::centroidDeviation, &D::maxMm>},
      {"deviation.centroid_times_curvature.mean", "Centroid x curv., mean", "", K::Significant, 3,
       true, B::Less,
       "times the largest principal curvature there, a pure number: about 0.008 for the triangles "
       "of an inscribed surface with 20 edges around a tube",
       within<&Q::centroidTimesCurvature, &F::mean>},
      {"deviation.centroid_times_curvature.p99", "Centroid x curv., 99 %", "", K::Significant, 3,
       false, B::Less, "", within<&Q::centroidTimesCurvature, &F::p99>},
      {"deviation.centroid_times_curvature.max", "Centroid x curv., most", "", K::Significant, 3,
       false, B::Less, "", within<&Q::centroidTimesCurvature, &F::max>},
  };
  return table;
}

std::string valueText(const QualityMeasure& measure, double value) {
  if (measure.kind == MeasureKind::YesNo) return value != 0.0 ? "yes" : "no";
  char text[64];
  std::snprintf(text, sizeof text, measure.kind == MeasureKind::Significant ? "%.*g" : "%.*f",
                measure.kind == MeasureKind::Count ? 0 : measure.digits, value);
  return text;
}

std::string measureText(const QualityMeasure& measure, const MeshQuality& quality) {
  const Value value = measure.value(quality);
  return value ? valueText(measure, *value) : "-";
}

std::vector<std::size_t> betterOnes(const QualityMeasure& measure,
                                    const std::vector<const MeshQuality*>& meshes) {
  if (measure.better == Better::Neither) return {};
  const double sign = measure.better == Better::More ? 1.0 : -1.0;
  Value best;
  std::size_t known = 0;
  for (const MeshQuality* mesh : meshes) {
    const Value value = mesh != nullptr ? measure.value(*mesh) : Value();
    if (!value) continue;
    ++known;
    if (!best || sign * *value > sign * *best) best = value;
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; best && i < meshes.size(); ++i) {
    const Value value = meshes[i] != nullptr ? measure.value(*meshes[i]) : Value();
    // What is written alike is alike to whoever reads it.
    if (value && valueText(measure, *value) == valueText(measure, *best)) found.push_back(i);
  }
  return found.size() < known ? found : std::vector<std::size_t>();
}

const QualityMeasure& qualityMeasure(const std::string& key) {
  const auto& table = qualityMeasures();
  return *std::find_if(table.begin(), table.end(),
                       [&key](const QualityMeasure& measure) { return key == measure.key; });
}

}  // namespace angiomesh

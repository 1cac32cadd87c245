// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/quality_table.h"

#include <algorithm>
#include <cctype>
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

Value fromFront(const Q& q) { return q.fromFrontPercent; }

/// No mesher chooses the shapes in corners of the outline.
template <auto elsewhere, auto all>
Value outsideCorners(const Q& q) {
  return q.corners ? Value((*q.corners).*elsewhere) : shape<all>(q);
}

std::string written(const QualityMeasure& measure, double value) {
  if (measure.kind == MeasureKind::YesNo) return value != 0.0 ? "yes" : "no";
  char text[64];
  std::snprintf(text, sizeof text, measure.kind == MeasureKind::Significant ? "%.*g" : "%.*f",
                measure.kind == MeasureKind::Count ? 0 : measure.digits, value);
  return text;
}

}  // namespace

const std::vector<QualityMeasure>& qualityMeasures() {
  using K = MeasureKind;
  using C = CornerShapes;
  using D = DeviationStats;
  using F = CurvedDeviation;
  static const std::vector<QualityMeasure> table{
      {"vertices", "Vertices", "", K::Count, 0, false, "points that triangles use",
       number<&Q::vertices>},
      {"triangles", "Triangles", "", K::Count, 0, true, "", number<&Q::triangles>},
      {"components", "Components", "", K::Count, 0, true, "edge-connected sets of triangles",
       number<&Q::components>},
      {"boundary_edges", "Boundary edges", "", K::Count, 0, false, "of open rims",
       number<&Q::boundaryEdges>},
      {"boundary_loops", "Boundary loops", "", K::Count, 0, false, "open rims",
       number<&Q::boundaryLoops>},
      {"non_manifold_edges", "Non-manifold edges", "", K::Count, 0, true,
       "edges of more than two triangles", number<&Q::nonManifoldEdges>},
      {"non_manifold_vertices", "Non-manifold vertices", "", K::Count, 0, true,
       "vertices whose triangles do not form a single fan", number<&Q::nonManifoldVertices>},
      {"degenerate_triangles", "Degenerate triangles", "", K::Count, 0, true,
       "exactly collinear or repeated corners", number<&Q::degenerateTriangles>},
      {"self_intersections", "Self-intersections", "", K::Count, 0, true,
       "pairs of triangles that meet outside shared corners and edges, by exact predicates",
       number<&Q::selfIntersections>},
      {"euler", "Euler number", "", K::Count, 0, false, "sum of 2 - 2 genus - rims",
       number<&Q::euler>},
      {"genus", "Genus", "", K::Count, 0, true, "sum over the components", number<&Q::genus>},
      {"closed", "Closed", "", K::YesNo, 0, true, "no boundary edge", number<&Q::closed>},
      {"oriented", "Oriented", "", K::YesNo, 0, true, "neighbours agree on the outside",
       number<&Q::oriented>},
      {"area_mm2", "Area", "mm2", K::Significant, 6, true, "", number<&Q::areaMm2>},
      {"volume_mm3", "Volume", "mm3", K::Significant, 6, true,
       "by the divergence theorem, positive for outward faces; absent if not closed and oriented",
       volume},
      {"min_angle_deg.min", "Least angle", "deg", K::Fixed, 2, true,
       "the smallest of all angles; gates leave out corners of the outline", shape<&Q::minAngleMin>,
       outsideCorners<&C::otherMinAngle, &Q::minAngleMin>},
      {"min_angle_deg.p01", "Min angle, 1 %", "deg", K::Fixed, 2, true,
       "1st percentile of the smallest angle of each triangle", shape<&Q::minAngleP01>},
      {"min_angle_deg.mean", "Min angle, mean", "deg", K::Fixed, 2, true, "",
       shape<&Q::minAngleMean>},
      {"max_angle_deg.max", "Largest angle", "deg", K::Fixed, 2, true, "", shape<&Q::maxAngleMax>,
       outsideCorners<&C::otherMaxAngle, &Q::maxAngleMax>},
      {"max_angle_deg.p99", "Max angle, 99 %", "deg", K::Fixed, 2, false,
       "99th percentile of the largest angle of each triangle", shape<&Q::maxAngleP99>},
      {"radius_ratio.min", "Least radius ratio", "", K::Fixed, 3, true,
       "2 * inradius / circumradius; 1 is equilateral", shape<&Q::radiusRatioMin>,
       outsideCorners<&C::otherRadiusRatio, &Q::radiusRatioMin>},
      {"radius_ratio.p01", "Radius ratio, 1 %", "", K::Fixed, 3, false, "1st percentile",
       shape<&Q::radiusRatioP01>},
      {"radius_ratio.mean", "Radius ratio, mean", "", K::Fixed, 4, true, "",
       shape<&Q::radiusRatioMean>},
      {"skewness.max", "Skewness, most", "", K::Fixed, 3, true,
       "equiangular skewness, as in Fluent: max((largest angle - 60) / 120, (60 - smallest) / 60); "
       "0 "
       "is equilateral, 1 has no area",
       shape<&Q::skewnessMax>},
      {"skewness.mean", "Skewness, mean", "", K::Fixed, 3, false, "", shape<&Q::skewnessMean>},
      {"corners.triangles", "Corner triangles", "", K::Count, 0, false,
       "those with two sides on the borders of two other patches, whose angles no mesher chooses; "
       "absent if there are none",
       within<&Q::corners, &C::triangles>},
      {"corners.min_angle_deg", "Min angle, corners", "deg", K::Fixed, 2, false,
       "in such triangles", within<&Q::corners, &C::minAngle>},
      {"corners.max_angle_deg", "Max angle, corners", "deg", K::Fixed, 2, false, "",
       within<&Q::corners, &C::maxAngle>},
      {"corners.radius_ratio", "Min ratio, corners", "", K::Fixed, 3, false, "",
       within<&Q::corners, &C::radiusRatio>},
      {"corners.elsewhere.min_angle_deg", "Min angle, others", "deg", K::Fixed, 2, false,
       "in all others", within<&Q::corners, &C::otherMinAngle>},
      {"corners.elsewhere.max_angle_deg", "Max angle, others", "deg", K::Fixed, 2, false, "",
       within<&Q::corners, &C::otherMaxAngle>},
      {"corners.elsewhere.radius_ratio", "Min ratio, others", "", K::Fixed, 3, false, "",
       within<&Q::corners, &C::otherRadiusRatio>},
      {"edge_length_mm.min", "Shortest edge", "mm", K::Significant, 4, false, "",
       shape<&Q::edgeMinMm>},
      {"edge_length_mm.mean", "Edge, mean", "mm", K::Significant, 4, true, "",
       shape<&Q::edgeMeanMm>},
      {"edge_length_mm.max", "Longest edge", "mm", K::Significant, 4, false, "",
       shape<&Q::edgeMaxMm>},
      {"below_20_deg_percent", "Below 20 deg", "%", K::Fixed, 3, true,
       "of the triangles, by smallest angle", shape<&Q::below20Percent>},
      {"below_30_deg_percent", "Below 30 deg", "%", K::Fixed, 3, true,
       "of the triangles, by smallest angle", shape<&Q::below30Percent>},
      {"roughness.spread_mm", "Roughness", "mm", K::Significant, 3, true,
       "median of the vertices' root mean square distance from a smooth fit around them, see "
       "report.md",
       within<&Q::roughness, &Roughness::spreadMm>},
      {"roughness.spread_p95_mm", "Roughness, 95 %", "mm", K::Significant, 3, false,
       "its 95th percentile; branchings and tips raise it",
       within<&Q::roughness, &Roughness::spread95Mm>},
      {"roughness.angle_deg", "Roughness, angle", "deg", K::Fixed, 2, true,
       "median of the angle between neighbouring triangles that neither their size nor the "
       "curvature "
       "of the wall explains",
       within<&Q::roughness, &Roughness::angleDeg>},
      {"from_front_percent", "From the front", "%", K::Fixed, 2, true,
       "share of the triangles that the advancing front made; absent for other methods", fromFront},
      {"deviation.vertex.mean_mm", "Vertex off, mean", "mm", K::Significant, 3, false,
       "distance from the zero set of the interpolant that was meshed, caps apart",
       within<&Q::vertexDeviation, &D::meanMm>},
      {"deviation.vertex.p99_mm", "Vertex off, 99 %", "mm", K::Significant, 3, false, "",
       within<&Q::vertexDeviation, &D::p99Mm>},
      {"deviation.vertex.max_mm", "Vertex off, most", "mm", K::Significant, 4, true, "",
       within<&Q::vertexDeviation, &D::maxMm>},
      {"deviation.centroid.mean_mm", "Centroid off, mean", "mm", K::Significant, 3, true,
       "the same of the centroids of the triangles", within<&Q::centroidDeviation, &D::meanMm>},
      {"deviation.centroid.p99_mm", "Centroid off, 99 %", "mm", K::Significant, 3, false, "",
       within<&Q::centroidDeviation, &D::p99Mm>},
      {"deviation.centroid.max_mm", "Centroid off, most", "mm", K::Significant, 4, true, "",
       within<&Q::centroidDeviation, &D::maxMm>},
      {"deviation.centroid_times_curvature.mean", "Centroid x curv., mean", "", K::Significant, 3,
       true,
       "times the largest principal curvature there, a pure number: about 0.008 for the triangles "
       "of an inscribed surface with 20 edges around a tube",
       within<&Q::centroidTimesCurvature, &F::mean>},
      {"deviation.centroid_times_curvature.p99", "Centroid x curv., 99 %", "", K::Significant, 3,
       false, "", within<&Q::centroidTimesCurvature, &F::p99>},
      {"deviation.centroid_times_curvature.max", "Centroid x curv., most", "", K::Significant, 3,
       false, "", within<&Q::centroidTimesCurvature, &F::max>},
  };
  return table;
}

std::string measureText(const QualityMeasure& measure, const MeshQuality& quality) {
  const Value value = measure.value(quality);
  return value ? written(measure, *value) : "-";
}

const std::vector<QualityGate>& qualityGates() {
  using Limits = std::vector<QualityGate::Limit>;
  const auto and_ = [](Limits limits, const Limits& more) {
    limits.insert(limits.end(), more.begin(), more.end());
    return limits;
  };
  static const Limits manifold{{"triangles", 1.0, true},
                               {"oriented", 1.0, true},
                               {"non_manifold_edges", 0.0, false},
                               {"non_manifold_vertices", 0.0, false},
                               {"degenerate_triangles", 0.0, false},
                               {"self_intersections", 0.0, false}};
  static const Limits closed = and_(manifold, {{"boundary_edges", 0.0, false}});
  static const std::vector<QualityGate> gates{
      {"manifold", "oriented, no non-manifold spot, degenerate triangle or self-intersection",
       manifold},
      {"closed", "as manifold, and no boundary edge", closed},
      {"cfd", "as closed, and no angle below 15 degrees",
       and_(closed, {{"min_angle_deg.min", 15.0, true}})},
      {"solver", "as closed, all angles from 30 to 110 degrees, all radius ratios at least 0.6",
       and_(closed, {{"min_angle_deg.min", 30.0, true},
                     {"max_angle_deg.max", 110.0, false},
                     {"radius_ratio.min", 0.6, true}})},
  };
  return gates;
}

std::vector<std::string> gateFailures(const QualityGate& gate, const MeshQuality& quality) {
  std::vector<std::string> failures;
  for (const QualityGate::Limit& limit : gate.limits) {
    const auto& table = qualityMeasures();
    const auto measure = std::find_if(table.begin(), table.end(), [&](const QualityMeasure& each) {
      return std::string(each.key) == limit.key;
    });
    const Value value = (measure->gated != nullptr ? measure->gated : measure->value)(quality);
    if (!value || (limit.atLeast ? *value >= limit.bound : *value <= limit.bound)) continue;
    std::string label = measure->label;
    label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
    if (measure->kind == MeasureKind::YesNo) {
      failures.push_back("not " + label);
    } else if (measure->kind == MeasureKind::Count) {
      failures.push_back((*value > 0.0 ? written(*measure, *value) : "no") + " " + label);
    } else {
      char bound[32];
      std::snprintf(bound, sizeof bound, "%g", limit.bound);
      failures.push_back(label + " " + written(*measure, *value) +
                         (*measure->unit != '\0' ? std::string(" ") + measure->unit : "") +
                         (limit.atLeast ? ", below " : ", above ") + bound);
    }
  }
  return failures;
}

}  // namespace angiomesh

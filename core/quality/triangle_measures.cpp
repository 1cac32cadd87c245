// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/triangle_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"
#include "core/mesh/triangle_shape.h"
#include "core/quality/mesh_quality.h"
#include "core/quality/neighbours.h"
#include "core/quality/quality_gates.h"
#include "core/quality/roughness.h"
#include "core/quality/wall_gaps.h"

namespace angiomesh {
namespace {

using Values = std::vector<float>;

template <auto member>
Values shape(const TriMesh& mesh, const Progress& /*progress*/) {
  Values values;
  values.reserve(mesh.triangles.size());
  for (const TriangleShape& s : shapesOf(mesh)) values.push_back(static_cast<float>(s.*member));
  return values;
}

Values skewness(const TriMesh& mesh, const Progress& /*progress*/) {
  Values values;
  values.reserve(mesh.triangles.size());
  for (const TriangleShape& s : shapesOf(mesh)) values.push_back(static_cast<float>(s.skewness()));
  return values;
}

Values valence(const TriMesh& mesh, const Progress& /*progress*/) {
  return valenceDepartures(mesh);
}

Values gradation(const TriMesh& mesh, const Progress& /*progress*/) { return sizeGradations(mesh); }

Values gap(const TriMesh& mesh, const Progress& progress) {
  return measureGaps(mesh, progress).gapEdges;
}

Values thickness(const TriMesh& mesh, const Progress& progress) {
  return measureGaps(mesh, progress).thicknessMm;
}

/// The mean of the three corners.
Values roughness(const TriMesh& mesh, const Progress& progress) {
  const Values spread = vertexSpreads(mesh, progress);
  Values values;
  values.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    values.push_back((spread[a] + spread[b] + spread[c]) / 3.0F);
  return values;
}

std::vector<float> numbers(const Values& values) {
  Values list;
  list.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(list),
               [](float value) { return !std::isnan(value); });
  return list;
}

}  // namespace

const std::vector<TriangleMeasure>& triangleMeasures() {
  using S = TriangleShape;
  static const std::vector<TriangleMeasure> table{
      {"min-angle",
       "Smallest angle",
       "deg",
       1,
       0.0,
       60.0,
       false,
       "min_angle_deg.min",
       {},
       "60 is equilateral",
       shape<&S::minAngle>},
      {"max-angle",
       "Largest angle",
       "deg",
       1,
       180.0,
       60.0,
       false,
       "max_angle_deg.max",
       {},
       "60 is equilateral",
       shape<&S::maxAngle>},
      {"radius-ratio",
       "Radius ratio",
       "",
       3,
       0.0,
       1.0,
       false,
       "radius_ratio.min",
       {},
       "2 * inradius / circumradius; 1 is equilateral",
       shape<&S::radiusRatio>},
      // The bands are those that Fluent's manual calls excellent, good, fair and poor.
      {"skewness",
       "Skewness",
       "",
       3,
       1.0,
       0.0,
       false,
       "",
       {0.25, 0.5, 0.75, 0.9},
       "of the angles; 0 is equilateral, 1 has no area",
       skewness},
      {"aspect-ratio",
       "Aspect ratio",
       "",
       2,
       4.0,
       1.0,
       false,
       "",
       {1.5, 2.0, 3.0},
       "longest edge / (inradius * 12^0.5); 1 is equilateral",
       shape<&S::aspectRatio>},
      {"valence",
       "Valence, off 6",
       "",
       0,
       4.0,
       0.0,
       false,
       "",
       {1.0, 2.0},
       "triangles at a vertex against the 6 of an even mesh, at the worst corner",
       valence},
      {"gradation",
       "Size gradation",
       "",
       2,
       2.5,
       1.0,
       false,
       "",
       {1.2, 1.5, 2.0},
       "mean edge over that of the neighbour that differs most, the larger over the smaller",
       gradation},
      {"gap",
       "Gap outside",
       "edges",
       2,
       0.0,
       gapReach,
       false,
       "gap.least_edges",
       {1.0, 2.0},
       "straight outwards to the wall again, in edges of the triangle",
       gap},
      {"thickness",
       "Thickness",
       "mm",
       2,
       0.0,
       1.0,
       true,
       "thickness_mm.p01",
       {},
       "straight inwards to the other side of the vessel",
       thickness},
      {"roughness",
       "Roughness",
       "mm",
       4,
       1.0,
       0.0,
       true,
       "",
       {},
       "distance of the vertices around from a smooth fit",
       roughness},
  };
  return table;
}

MeasureScale scaleOf(const TriangleMeasure& measure, const std::vector<const Values*>& meshes) {
  MeasureScale scale{measure.worst, measure.best};
  if (!measure.fitted) return scale;
  double most = 0.0;
  for (const Values* values : meshes) {
    Values known = values != nullptr ? numbers(*values) : Values();
    if (!known.empty()) most = std::max(most, percentile(known, 0.98));
  }
  if (most > 0.0) (measure.lessIsBetter() ? scale.worst : scale.best) = most;
  return scale;
}

std::vector<BandLimit> bandLimits(const TriangleMeasure& measure) {
  std::vector<BandLimit> limits;
  for (const double at : measure.bands) limits.push_back({at, {}});
  for (const QualityGate& gate : qualityGates())
    for (const QualityGate::Limit& limit : gate.limits)
      if (measure.gateKey == std::string(limit.key)) limits.push_back({limit.bound, gate.name});
  std::sort(limits.begin(), limits.end(),
            [](const BandLimit& a, const BandLimit& b) { return a.at < b.at; });
  return limits;
}

std::vector<double> bandShares(const TriangleMeasure& measure, const Values& values) {
  const std::vector<BandLimit> limits = bandLimits(measure);
  std::vector<std::size_t> counts(limits.size() + 1, 0);
  std::size_t all = 0;
  for (const float value : values) {
    if (std::isnan(value)) continue;
    std::size_t band = 0;
    for (const BandLimit& limit : limits) {
      // As precise as the values are.
      const auto at = static_cast<float>(limit.at);
      if (measure.lessIsBetter() ? value > at : value >= at) ++band;
    }
    ++counts[band];
    ++all;
  }
  std::vector<double> shares;
  for (const std::size_t count : counts)
    shares.push_back(all == 0 ? 0.0
                              : 100.0 * static_cast<double>(count) / static_cast<double>(all));
  return shares;
}

std::vector<std::uint32_t> worstTriangles(const TriangleMeasure& measure, const TriMesh& mesh,
                                          const Values& values, std::size_t most) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t t = 0; t < values.size(); ++t)
    if (!std::isnan(values[t])) order.push_back(t);
  const auto worse = [&](std::uint32_t a, std::uint32_t b) {
    if (values[a] != values[b])
      return measure.lessIsBetter() ? values[a] > values[b] : values[a] < values[b];
    return a < b;
  };
  std::vector<std::uint32_t> found;
  std::vector<char> taken(mesh.points.size(), 0);
  // Sorted piece by piece: of a large mesh the first few are enough.
  for (std::size_t from = 0, piece = 64 * most; from < order.size() && found.size() < most;
       from += piece) {
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last =
        order.begin() + static_cast<std::ptrdiff_t>(std::min(from + piece, order.size()));
    std::partial_sort(first, last, order.end(), worse);
    for (auto at = first; at != last && found.size() < most; ++at) {
      const auto& corners = mesh.triangles[*at];
      if (std::any_of(corners.begin(), corners.end(), [&](auto v) { return taken[v] != 0; }))
        continue;
      for (const std::uint32_t v : corners) taken[v] = 1;
      found.push_back(*at);
    }
  }
  return found;
}

}  // namespace angiomesh

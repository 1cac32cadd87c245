// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/neighbours.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr int kEven = 6;
constexpr std::size_t kBlock = 4096;

/// Of each vertex; 0 for those on open rims, and without triangles.
std::vector<int> innerValences(const TriMesh& mesh) {
  std::vector<int> valence(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    if (!repeatsVertex(t))
      for (const std::uint32_t v : t) ++valence[v];
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i))
    if (edgeRunEnd(sides, i) == i + 1) valence[sides[i].low] = valence[sides[i].high] = 0;
  return valence;
}

double meanEdgeMm(const TriMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return ((mesh.points[b] - mesh.points[a]).norm() + (mesh.points[c] - mesh.points[b]).norm() +
          (mesh.points[a] - mesh.points[c]).norm()) /
         3.0;
}

}  // namespace

std::optional<Valences> measureValences(const TriMesh& mesh) {
  Valences result;
  std::size_t counted = 0, regular = 0;
  for (const int valence : innerValences(mesh)) {
    if (valence == 0) continue;
    result.least = counted == 0 ? valence : std::min(result.least, valence);
    result.most = std::max(result.most, valence);
    ++counted;
    if (std::abs(valence - kEven) <= 1) ++regular;
  }
  if (counted == 0) return std::nullopt;
  result.regularPercent = 100.0 * static_cast<double>(regular) / static_cast<double>(counted);
  return result;
}

std::vector<float> valenceDepartures(const TriMesh& mesh) {
  const std::vector<int> valence = innerValences(mesh);
  std::vector<float> most(mesh.triangles.size(), kNone);
  for (std::size_t t = 0; t < most.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (valence[v] != 0)
        most[t] = std::fmax(most[t], static_cast<float>(std::abs(valence[v] - kEven)));
  return most;
}

std::vector<float> sizeGradations(const TriMesh& mesh) {
  std::vector<double> edge(mesh.triangles.size());
  parallelForEach(edge.size(), kBlock, [&](std::size_t t) { edge[t] = meanEdgeMm(mesh, t); });
  std::vector<float> most(mesh.triangles.size(), kNone);
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    const std::size_t end = edgeRunEnd(sides, i);
    if (end == i + 1) continue;
    const auto length = [&](std::size_t k) { return edge[sides[k].triangle]; };
    double shortest = length(i), longest = length(i);
    for (std::size_t k = i; k < end; ++k) {
      shortest = std::min(shortest, length(k));
      longest = std::max(longest, length(k));
    }
    for (std::size_t k = i; k < end; ++k) {
      const double ratio = std::max(longest / length(k), length(k) / shortest);
      float& known = most[sides[k].triangle];
      known = std::fmax(known, static_cast<float>(ratio));
    }
  }
  return most;
}

}  // namespace angiomesh

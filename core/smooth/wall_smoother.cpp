// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/wall_smoother.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/triangle_shape.h"

namespace angiomesh {

TriMesh WallSmoother::run(const Progress& progress) {
  const std::vector<double> before = wallOffsets(progress);
  const int sweeps = params_.iterations;
  for (int i = 0; i < sweeps; ++i) {
    relax(params_.lambda, progress);
    // Even valences first, as they let the vertices spread; angles in the end.
    if (i % 5 == 4) flipEdges(i + 10 < sweeps, progress);
    progress.report(0.8 * (i + 1) / sweeps);
  }
  refreshNormals();
  for (int i = 0; i < 6; ++i) {
    if (improveWorst(progress) == 0) break;
    flipEdges(false, progress);
  }
  progress.report(0.9);
  for (int i = 0; i < 3; ++i) relax(0.0, progress);
  refreshNormals();
  std::vector<double> given(points_.size(), 0.0);
  for (int i = 0; i < 2; ++i) restoreOffsets(before, given, progress);
  enforceBound(progress);
  return {points_, edges_.triangles(), patch_};
}

int WallSmoother::excess(std::uint32_t v, int change) const {
  return std::abs(edges_.valence(v) + change - (edges_.onRim(v) ? 4 : 6));
}

// Whether flipping h makes a better pair of triangles on the same surface.
bool WallSmoother::worthFlipping(std::uint32_t h, bool byValence) const {
  const std::uint32_t g = edges_.twin(h);
  if (!patch_.empty() && patch_[h / 3] != patch_[g / 3]) return false;
  const std::uint32_t a = edges_.origin(h), b = edges_.origin(g);
  const std::uint32_t c = edges_.origin(HalfEdges::previous(h));
  const std::uint32_t d = edges_.origin(HalfEdges::previous(g));
  for (const std::uint32_t v : {a, b, c, d}) {
    if (freedom_[v].fixed) return false;
  }
  const Corners s{a, b, c}, t{b, a, d}, u{a, d, c}, w{d, b, c};
  const bool inCap = inOneCap(s);
  if (inOneCap(t) != inCap || inOneCap(u) != inCap || inOneCap(w) != inCap) return false;

  const Fitness fs = fitness(s, points_), ft = fitness(t, points_);
  const Fitness fu = fitness(u, points_), fw = fitness(w, points_);
  const double sharpBefore = std::max(fs.sharpness, ft.sharpness);
  const double sharpAfter = std::max(fu.sharpness, fw.sharpness);
  if (byValence) {
    const int now = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
    const int then = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
    if (then > now || sharpAfter > std::max(0.95, sharpBefore)) return false;
    if (then == now && sharpAfter > sharpBefore - 0.01) return false;
  } else if (sharpAfter > sharpBefore - 1e-3) {
    return false;
  }
  const double agreeBefore = std::min(fs.agreement, ft.agreement);
  const double agreeAfter = std::min(fu.agreement, fw.agreement);
  if (agreeAfter < std::min(0.7, agreeBefore)) return false;
  const auto bend = [&](const Corners& p, const Corners& q) {
    return unitNormal(points_[p[0]], points_[p[1]], points_[p[2]])
        .dot(unitNormal(points_[q[0]], points_[q[1]], points_[q[2]]));
  };
  return bend(u, w) >= std::min(0.85, bend(s, t));
}

void WallSmoother::flipEdges(bool byValence, const Progress& progress) {
  const auto count = static_cast<std::uint32_t>(3 * edges_.triangles().size());
  for (std::uint32_t h = 0; h < count; ++h) {
    if (h % 16384 == 0) progress.check();
    const std::uint32_t g = edges_.twin(h);
    if (g == HalfEdges::none || g < h) continue;
    if (worthFlipping(h, byValence) && edges_.canFlip(h)) edges_.flip(h);
  }
}

// The worst of the triangles around v if it were at `place`.
WallSmoother::Fitness WallSmoother::around(std::uint32_t v, const Ring& ring, std::size_t n,
                                           const Vector3d& place, const Vector3d& normal) const {
  Fitness worst;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = ring[i], b = ring[(i + 1) % n];
    const Vector3d m = unitNormal(place, points_[a], points_[b]);
    double agreement = m.dot(normal);
    if (!inOneCap({v, a, b})) {
      for (const std::uint32_t u : {a, b}) {
        if (!freedom_[u].cap) agreement = std::min(agreement, m.dot(normals_[u]));
      }
    }
    worst.agreement = std::min(worst.agreement, agreement);
    worst.sharpness = std::max(worst.sharpness, largestCosine(place, points_[a], points_[b]));
  }
  return worst;
}

// Looks about v, along the wall, for the place where the worst triangle around it is best.
bool WallSmoother::improve(std::uint32_t v) {
  if (freedom_[v].fixed || edges_.onRim(v)) return false;
  const Surroundings s = surroundings(v);
  if (s.count == 0 || (freedom_[v].cap && !s.insideCap)) return false;
  Ring ring{};
  const std::size_t n = ringOf(v, ring);
  Vector3d normal = s.insideCap ? freedom_[v].planeNormal : normals_[v];
  if (normal.isZero()) return false;
  Fitness best = around(v, ring, n, points_[v], normal);
  const double reach = 0.5 * wall_.offsetLimitMm(params_.wallBoundVoxels);
  bool moved = false;
  double step = 0.25 * (points_[ring[0]] - points_[v]).norm();
  for (int round = 0; round < 4; ++round, step *= 0.5) {
    const Vector3d from = points_[v];
    const Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    for (int k = 0; k < 8; ++k) {
      static constexpr double half = 0.70710678118654752;
      static constexpr double turn[8][2] = {{1, 0},  {half, half},   {0, 1},  {-half, half},
                                            {-1, 0}, {-half, -half}, {0, -1}, {half, -half}};
      Vector3d place = from + step * (turn[k][0] * x + turn[k][1] * y);
      Vector3d there = normal;
      Fitness f = around(v, ring, n, place, there);
      if (f.sharpness >= best.sharpness - 1e-4) continue;
      if (!s.insideCap) {
        for (int newton = 0; newton < 2; ++newton) place += toWall(v, wall_.at(place), 0.0);
        const Wall::Sample reached = wall_.at(place);
        if (std::abs(reached.offset) > reach) continue;
        there = reached.normal;
        f = around(v, ring, n, place, there);
      }
      if (f.sharpness >= best.sharpness - 1e-4) continue;
      if (f.agreement < std::min(0.6, best.agreement)) continue;
      best = f;
      points_[v] = place;
      normals_[v] = there;
      moved = true;
    }
    normal = s.insideCap ? normal : normals_[v];
  }
  return moved;
}

// Works on the vertices of triangles with an angle below 33 degrees; returns how many moved.
std::size_t WallSmoother::improveWorst(const Progress& progress) {
  std::vector<char> bad(points_.size(), 0);
  for (const Corners& t : edges_.triangles()) {
    if (largestCosine(points_[t[0]], points_[t[1]], points_[t[2]]) < 0.8387) continue;
    for (const std::uint32_t v : t) bad[v] = 1;
  }
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (v % 1024 == 0) progress.check();
    if (bad[v] != 0 && improve(v)) ++count;
  }
  return count;
}

}  // namespace angiomesh

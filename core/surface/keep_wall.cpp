// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/base/parallel.h"
#include "core/quality/self_intersection.h"
#include "core/surface/half_edges.h"
#include "core/surface/smoothing.h"
#include "core/surface/wall.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Corners = std::array<std::uint32_t, 3>;

constexpr std::size_t blockSize = 2048;

// What a vertex may do. A cap is a plane half a voxel outside the grid of phi, an open rim lies in
// the outermost plane of voxel centres: their vertices stay in these planes.
struct Freedom {
  bool fixed = false;
  bool cap = false;
  int axis = -1;                  ///< index axis that is held; -1: none
  Vector3d planeNormal{0, 0, 0};  ///< outward
};

double largestCosine(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, bc = c - b, ca = a - c;
  const double x = ab.norm(), y = bc.norm(), z = ca.norm();
  if (!(x > 0.0 && y > 0.0 && z > 0.0)) return 1.0;
  return std::max({-ab.dot(ca) / (x * z), -bc.dot(ab) / (x * y), -ca.dot(bc) / (y * z)});
}

Vector3d unitNormal(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0.0 ? Vector3d(n / length) : Vector3d::Zero();
}

class WallSmoother {
 public:
  WallSmoother(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
               const Wall& wall, const std::vector<char>& frozen)
      : params_(params),
        phi_(phi),
        wall_(wall),
        edges_(mesh),
        points_(mesh.points),
        freedom_(mesh.points.size()),
        normals_(mesh.points.size(), Vector3d::Zero()) {
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      freedom_[v].fixed = frozen[v] != 0 || edges_.irregular(v);
    }
    if (phi_ != nullptr) findPlanes();
    fixTips();
    refreshNormals();
  }

  TriMesh run(const Progress& progress) {
    const std::vector<double> before = wallOffsets(progress);
    const int sweeps = params_.iterations;
    for (int i = 0; i < sweeps; ++i) {
      relax(params_.lambda, progress);
      if (i % 5 == 4) flipEdges(i + 10 < sweeps, progress);
      progress.report(0.9 * (i + 1) / sweeps);
    }
    for (int i = 0; i < 3; ++i) relax(0.0, progress);
    std::vector<double> given(points_.size(), 0.0);
    for (int i = 0; i < 2; ++i) restoreOffsets(before, given, progress);
    return {points_, edges_.triangles()};
  }

 private:
  void findPlanes() {
    const Geometry& g = phi_->geometry();
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      const Vector3d index = g.toIndex(points_[v]);
      for (int axis = 0; axis < 3; ++axis) {
        const double last = g.size[static_cast<std::size_t>(axis)] - 1;
        const double beyond = std::max(-index[axis], index[axis] - last);
        const bool cap = beyond > 0.25;
        const bool rim = std::abs(beyond) < 1e-6 && edges_.onRim(v);
        if (!cap && !rim) continue;
        if (freedom_[v].axis >= 0) freedom_[v].fixed = true;
        freedom_[v].axis = axis;
        freedom_[v].cap = freedom_[v].cap || cap;
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        Vector3d n = g.direction.col(b).cross(g.direction.col(c)).normalized();
        if (n.dot(g.direction.col(axis)) < 0.0) n = -n;
        freedom_[v].planeNormal = index[axis] < 0.5 * last ? Vector3d(-n) : n;
      }
    }
  }

  [[nodiscard]] bool inOneCap(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Freedom &x = freedom_[a], &y = freedom_[b], &z = freedom_[c];
    return x.cap && y.cap && z.cap && x.planeNormal == y.planeNormal &&
           x.planeNormal == z.planeNormal;
  }
  [[nodiscard]] bool inOneCap(const Corners& t) const { return inOneCap(t[0], t[1], t[2]); }

  // A cap of no triangle has no inside to smooth.
  void fixTips() {
    std::vector<char> covered(points_.size(), 0);
    for (const Corners& t : edges_.triangles()) {
      if (!inOneCap(t)) continue;
      for (const std::uint32_t v : t) covered[v] = 1;
    }
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (freedom_[v].cap && covered[v] == 0) freedom_[v].fixed = true;
    }
  }

  // Neighbours to average over, and whether the vertex lies inside a cap (no wall to follow).
  struct Surroundings {
    Vector3d mean{0, 0, 0};
    int count = 0;
    bool insideCap = false;
    std::array<std::uint32_t, 2> alongRim{HalfEdges::none, HalfEdges::none};
  };

  [[nodiscard]] Surroundings surroundings(std::uint32_t v) const {
    std::array<std::uint32_t, 64> ring{};
    std::size_t n = 0;
    edges_.forEachNeighbour(v, [&](std::uint32_t u) {
      if (n < ring.size()) ring[n++] = u;
    });
    Surroundings s;
    const auto take = [&](std::uint32_t u) {
      s.mean += points_[u];
      ++s.count;
    };
    if (n == 0) return s;
    if (edges_.onRim(v)) {
      s.alongRim = {ring[0], ring[n - 1]};
      for (const std::uint32_t u : s.alongRim) take(u);
    } else if (freedom_[v].cap) {
      std::size_t capTriangles = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const bool before = inOneCap(v, ring[(i + n - 1) % n], ring[i]);
        const bool after = inOneCap(v, ring[i], ring[(i + 1) % n]);
        if (after) ++capTriangles;
        if (before != after) take(ring[i]);
      }
      s.insideCap = capTriangles == n;
      if (s.insideCap) std::for_each(ring.begin(), ring.begin() + n, take);
    } else {
      std::for_each(ring.begin(), ring.begin() + n, take);
    }
    if (s.count > 0) s.mean /= s.count;
    return s;
  }

  // Without its part along the plane's normal, for a vertex that is held in a plane.
  [[nodiscard]] Vector3d held(std::uint32_t v, const Vector3d& step) const {
    if (freedom_[v].axis < 0) return step;
    return step - step.dot(freedom_[v].planeNormal) * freedom_[v].planeNormal;
  }

  // The step from p to the surface at `offset` from the wall, within the vertex's plane.
  [[nodiscard]] Vector3d toWall(std::uint32_t v, const Wall::Sample& s, double offset) const {
    const Vector3d direction = held(v, s.normal);
    const double share = direction.squaredNorm();
    if (share < 0.1) return Vector3d::Zero();
    return (offset - s.offset) / share * direction;
  }

  // A rim in no known plane is kept as the line that it is: its vertices slide along it to the
  // middle between their neighbours.
  [[nodiscard]] Vector3d alongRim(std::uint32_t v, const Surroundings& s, double factor) const {
    const Vector3d a = points_[s.alongRim[0]] - points_[v], b = points_[s.alongRim[1]] - points_[v];
    const double toA = a.norm(), toB = b.norm();
    const Vector3d& longer = toA > toB ? a : b;
    const double length = std::max(toA, toB);
    if (!(length > 0.0)) return Vector3d::Zero();
    return factor * std::abs(toA - toB) / (2.0 * length) * longer;
  }

  void refreshNormals() {
    parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) normals_[v] = wall_.at(points_[v]).normal;
    });
  }

  // One sweep: towards the neighbours' mean along the wall, then back onto the wall.
  void relax(double factor, const Progress& progress) {
    std::vector<Vector3d> moved = points_;
    const double longest = 0.25 * wall_.unitMm();
    parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t i = first; i < last; ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (freedom_[v].fixed) continue;
        const Surroundings s = surroundings(v);
        if (s.count == 0) continue;
        if (s.alongRim[0] != HalfEdges::none && freedom_[v].axis < 0) {
          moved[v] += alongRim(v, s, factor);
          continue;
        }
        Vector3d step = factor * (s.mean - points_[v]);
        if (!s.insideCap) {
          if (normals_[v].isZero()) continue;
          step -= step.dot(normals_[v]) * normals_[v];
        }
        step = held(v, step);
        if (!s.insideCap) step += toWall(v, wall_.at(points_[v] + step), 0.0);
        const double length = step.norm();
        if (length > longest) step *= longest / length;
        moved[v] += step;
      }
    });
    accept(moved, progress);
    refreshNormals();
  }

  // How well a triangle agrees with the wall (the smallest cosine of their normals), and the
  // largest cosine of its angles.
  struct Fitness {
    double agreement = 1.0, sharpness = 0.0;
  };

  [[nodiscard]] Fitness fitness(const Corners& t, const std::vector<Vector3d>& at) const {
    const Vector3d n = unitNormal(at[t[0]], at[t[1]], at[t[2]]);
    Fitness f;
    f.sharpness = largestCosine(at[t[0]], at[t[1]], at[t[2]]);
    if (inOneCap(t)) {
      f.agreement = n.dot(freedom_[t[0]].planeNormal);
      return f;
    }
    for (const std::uint32_t v : t) {
      if (!freedom_[v].cap) f.agreement = std::min(f.agreement, n.dot(normals_[v]));
    }
    return f;
  }

  // Takes the new places except where a triangle would turn away from the wall or lose its shape:
  // its corners stay.
  void accept(std::vector<Vector3d>& moved, const Progress& progress) {
    const auto& triangles = edges_.triangles();
    std::vector<char> bad(triangles.size());
    bool any = true;
    while (any) {
      parallelFor(0, triangles.size(), blockSize, [&](std::size_t first, std::size_t last) {
        progress.check();
        for (std::size_t i = first; i < last; ++i) {
          bad[i] = 0;
          const Corners& t = triangles[i];
          const bool still = moved[t[0]] == points_[t[0]] && moved[t[1]] == points_[t[1]] &&
                             moved[t[2]] == points_[t[2]];
          if (still) continue;
          const Fitness after = fitness(t, moved);
          if (after.agreement >= 0.5 && after.sharpness <= 0.985) continue;
          const Fitness now = fitness(t, points_);
          const bool turns = after.agreement < 0.5 && after.agreement < now.agreement;
          const bool thins = after.sharpness > 0.985 && after.sharpness > now.sharpness;
          if (turns || thins) bad[i] = 1;
        }
      });
      any = false;
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (bad[i] == 0) continue;
        any = true;
        for (const std::uint32_t v : triangles[i]) moved[v] = points_[v];
      }
    }
    points_.swap(moved);
  }

  [[nodiscard]] int excess(std::uint32_t v, int change) const {
    return std::abs(edges_.valence(v) + change - (edges_.onRim(v) ? 4 : 6));
  }

  // Whether flipping h makes a better pair of triangles on the same surface.
  [[nodiscard]] bool worthFlipping(std::uint32_t h, bool byValence) const {
    const std::uint32_t g = edges_.twin(h);
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

  void flipEdges(bool byValence, const Progress& progress) {
    const auto count = static_cast<std::uint32_t>(3 * edges_.triangles().size());
    for (std::uint32_t h = 0; h < count; ++h) {
      if (h % 16384 == 0) progress.check();
      const std::uint32_t g = edges_.twin(h);
      if (g == HalfEdges::none || g < h) continue;
      if (worthFlipping(h, byValence) && edges_.canFlip(h)) edges_.flip(h);
    }
  }

  // Mean signed distance of the triangles around each vertex from the wall. The mean over the
  // middles of the edges integrates a quadratic exactly: it sees the chords cut the curve.
  [[nodiscard]] std::vector<double> wallOffsets(const Progress& progress) const {
    const auto& triangles = edges_.triangles();
    std::vector<double> volume(triangles.size()), area(triangles.size());
    parallelFor(0, triangles.size(), blockSize, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t i = first; i < last; ++i) {
        const Corners& t = triangles[i];
        if (freedom_[t[0]].cap || freedom_[t[1]].cap || freedom_[t[2]].cap) continue;
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          const Vector3d middle = 0.5 * (points_[t[k]] + points_[t[(k + 1) % 3]]);
          sum += wall_.at(middle).offset / 3.0;
        }
        area[i] = (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]).norm();
        volume[i] = area[i] * sum;
      }
    });
    std::vector<double> volumes(points_.size(), 0.0), areas(points_.size(), 0.0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (const std::uint32_t v : triangles[i]) {
        volumes[v] += volume[i];
        areas[v] += area[i];
      }
    }
    // Averaged over some rings: the triangles that met in a vertex before do not meet there after.
    for (int round = 0; round < 8; ++round) {
      spread(volumes);
      spread(areas);
    }
    for (std::size_t v = 0; v < volumes.size(); ++v) {
      volumes[v] = areas[v] > 0.0 ? volumes[v] / areas[v] : 0.0;
    }
    return volumes;
  }

  void spread(std::vector<double>& values) const {
    std::vector<double> next(values.size());
    parallelFor(0, values.size(), blockSize, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        double sum = 0.0;
        int count = 0;
        edges_.forEachNeighbour(static_cast<std::uint32_t>(v), [&](std::uint32_t u) {
          sum += values[u];
          ++count;
        });
        next[v] = count > 0 ? 0.5 * values[v] + 0.5 * sum / count : values[v];
      }
    });
    values.swap(next);
  }

  // Moves the vertices off the wall by what brings back the volume that the mesh enclosed before,
  // place by place, as far as the bound allows.
  void restoreOffsets(const std::vector<double>& before, std::vector<double>& given,
                      const Progress& progress) {
    const std::vector<double> now = wallOffsets(progress);
    const double bound = 0.98 * params_.wallBoundVoxels * wall_.unitMm();
    std::vector<Vector3d> moved = points_;
    parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t i = first; i < last; ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (freedom_[v].fixed || freedom_[v].cap) continue;
        if (freedom_[v].axis < 0 && edges_.onRim(v)) continue;
        given[v] = std::clamp(given[v] + before[v] - now[v], -bound, bound);
        const Wall::Sample s = wall_.at(points_[v]);
        if (!s.normal.isZero()) moved[v] += toWall(v, s, given[v]);
      }
    });
    accept(moved, progress);
  }

  const SmoothParams& params_;
  const SplineField* phi_;
  const Wall& wall_;
  HalfEdges edges_;
  std::vector<Vector3d> points_;
  std::vector<Freedom> freedom_;
  std::vector<Vector3d> normals_;  ///< of the wall at the vertices
};

// Freezes the surroundings of the triangles that came to meet; false when none did that were not
// frozen already.
bool freezeMeeting(const TriMesh& smoothed, std::vector<char>& frozen, const Progress& progress) {
  std::vector<char> grown = frozen;
  bool any = false;
  for (const auto& pair : selfIntersections(smoothed, progress)) {
    for (const std::uint32_t triangle : {pair.first, pair.second}) {
      for (const std::uint32_t v : smoothed.triangles[triangle]) {
        any = any || frozen[v] == 0;
        grown[v] = 1;
      }
    }
  }
  if (!any) return false;
  for (int ring = 0; ring < 3; ++ring) {
    const std::vector<char> inner = grown;
    for (const Corners& t : smoothed.triangles) {
      if (inner[t[0]] == 0 && inner[t[1]] == 0 && inner[t[2]] == 0) continue;
      for (const std::uint32_t v : t) grown[v] = 1;
    }
  }
  frozen.swap(grown);
  return true;
}

}  // namespace

TriMesh keepWallSmooth(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
                       const Progress& progress) {
  progress.report(0.0);
  if (mesh.triangles.empty() || params.iterations <= 0) return mesh;
  std::unique_ptr<Wall> wall;
  if (phi != nullptr) {
    wall = std::make_unique<ZeroSetWall>(*phi);
  } else {
    wall = std::make_unique<MeshWall>(mesh, params.wallBoundVoxels, progress);
  }
  std::vector<char> frozen(mesh.points.size(), 0);
  constexpr int attempts = 5;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const double from = attempt == 0 ? 0.0 : 0.9;
    TriMesh smoothed = WallSmoother(mesh, params, phi, *wall, frozen)
                           .run(progress.sub(from, attempt == 0 ? 0.85 : 0.95));
    if (!freezeMeeting(smoothed, frozen, progress.sub(0.85, 0.9))) {
      progress.report(1.0);
      return smoothed;
    }
  }
  return mesh;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/wall_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/triangle_shape.h"
#include "core/openings/held_planes.h"

namespace angiomesh {
namespace {
constexpr std::size_t blockSize = 2048;

// Per patch: whether phi ends there, as that of a run with cuts does, and its wall goes on over the
// cap.
std::vector<char> closedPatches(const TriMesh& mesh, const SplineField* phi) {
  const std::size_t count = *std::max_element(mesh.patch.begin(), mesh.patch.end());
  std::vector<char> closed(count + 1, 0);
  if (phi == nullptr) return closed;
  const Geometry& g = phi->geometry();
  const std::vector<Port> patches = measurePatches(mesh, count);
  for (std::size_t n = 0; n < count; ++n) {
    const Eigen::Vector3d beyond = patches[n].centreLps + g.voxelMm() * patches[n].normalLps;
    closed[n + 1] = static_cast<char>(g.holds(beyond) && phi->valueAt(beyond) >= 0.0);
  }
  return closed;
}
}  // namespace

WallVertices::WallVertices(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
                           const Wall& wall, const std::vector<Port>& ports,
                           const std::vector<char>& frozen)
    : params_(params),
      wall_(wall),
      edges_(mesh),
      patch_(mesh.patch),
      points_(mesh.points),
      freedom_(mesh.points.size()),
      normals_(mesh.points.size(), Vector3d::Zero()) {
  constexpr int ringLimit = std::tuple_size_v<Ring> - 1;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    freedom_[v].fixed = frozen[v] != 0 || edges_.irregular(v) || edges_.valence(v) >= ringLimit;
  }
  if (phi != nullptr) findPlanes(phi->geometry());
  if (!mesh.patch.empty()) holdPatches(mesh, ports, phi);
  fixTips();
  refreshNormals();
}

void WallVertices::findPlanes(const Geometry& g) {
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    const Vector3d index = g.toIndex(points_[v]);
    Freedom& f = freedom_[v];
    for (int axis = 0; axis < 3; ++axis) {
      const double last = g.size[static_cast<std::size_t>(axis)] - 1;
      const double beyond = std::max(-index[axis], index[axis] - last);
      const bool cap = beyond > 0.25;
      const bool rim = std::abs(beyond) < 1e-6 && edges_.onRim(v);
      if (!cap && !rim) continue;
      // Where two planes meet, nothing is left to choose.
      if (f.held) f.fixed = true;
      f.held = true;
      f.cap = f.cap || cap;
      const auto inPlane = [&](int k) { return g.direction.col((axis + k) % 3); };
      Vector3d n = inPlane(1).cross(inPlane(2)).normalized();
      if (n.dot(g.direction.col(axis)) < 0.0) n = -n;
      f.planeNormal = index[axis] < 0.5 * last ? Vector3d(-n) : n;
    }
  }
}

void WallVertices::holdPatches(const TriMesh& mesh, const std::vector<Port>& ports,
                               const SplineField* phi) {
  const HeldPlanes held(mesh, nullptr, ports);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (held.isCap(t)) freedom_[v].cap = true;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (held.count(v) == 0) continue;
    Freedom& f = freedom_[v];
    if (held.count(v) > 1) f.fixed = true;
    f.held = true;
    f.planeNormal = held.normal(v);
  }
  // Where the wall goes on over the cap nothing tells where the rim is.
  const std::vector<char> closed = closedPatches(mesh, phi);
  for (const RimEdge& edge : rimEdges(mesh)) {
    const std::size_t patch = edge.open ? 0U : edge.otherPatch;
    if (phi != nullptr && closed[patch] == 0) continue;
    for (const std::uint32_t v : {edge.from, edge.to}) freedom_[v].held = false;
  }
}

bool WallVertices::inOneCap(const Corners& t) const {
  const Freedom &a = freedom_[t[0]], &b = freedom_[t[1]], &c = freedom_[t[2]];
  return a.cap && b.cap && c.cap && a.planeNormal == b.planeNormal &&
         a.planeNormal == c.planeNormal;
}

// A cap of no triangle has no inside to smooth, and where two caps meet there is no wall to follow.
void WallVertices::fixTips() {
  std::vector<char> covered(points_.size(), 0);
  for (const Corners& t : edges_.triangles()) {
    const bool inOne = inOneCap(t);
    for (const std::uint32_t v : t) {
      if (inOne) covered[v] = 1;
      for (const std::uint32_t u : t) {
        const Freedom &a = freedom_[u], &b = freedom_[v];
        if (a.cap && b.cap && a.planeNormal != b.planeNormal) freedom_[v].fixed = true;
      }
    }
  }
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (freedom_[v].cap && covered[v] == 0) freedom_[v].fixed = true;
  }
}

// The neighbours of v in order, and their number.
std::size_t WallVertices::ringOf(std::uint32_t v, Ring& ring) const {
  std::size_t n = 0;
  edges_.forEachNeighbour(v, [&](std::uint32_t u) {
    if (n < ring.size()) ring[n++] = u;
  });
  return n;
}

WallVertices::Surroundings WallVertices::surroundings(std::uint32_t v) const {
  Ring ring{};
  const std::size_t n = ringOf(v, ring);
  Surroundings s;
  double weights = 0.0;
  // More weight where the wall bends: even edges alone would pull the vertices off the tips.
  const auto take = [&](std::uint32_t u) {
    const double weight = 1.0 + 4.0 * (1.0 - normals_[u].dot(normals_[v]));
    s.mean += weight * points_[u];
    weights += weight;
    ++s.count;
  };
  if (n == 0) return s;
  if (edges_.onRim(v)) {
    s.alongRim = {ring[0], ring[n - 1]};
    for (const std::uint32_t u : s.alongRim) take(u);
  } else if (freedom_[v].cap) {
    std::size_t capTriangles = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const bool before = inOneCap({v, ring[(i + n - 1) % n], ring[i]});
      const bool after = inOneCap({v, ring[i], ring[(i + 1) % n]});
      if (after) ++capTriangles;
      if (before == after) continue;
      s.alongRim[s.count == 0 ? 0 : 1] = ring[i];
      take(ring[i]);
    }
    if (s.count != 2) s.alongRim = {HalfEdges::none, HalfEdges::none};
    s.insideCap = capTriangles == n;
    if (s.insideCap) std::for_each(ring.begin(), ring.begin() + n, take);
  } else {
    std::for_each(ring.begin(), ring.begin() + n, take);
  }
  if (s.count > 0) s.mean /= weights;
  return s;
}

// Without its part along the plane's normal, for a vertex that is held in a plane.
Eigen::Vector3d WallVertices::heldStep(std::uint32_t v, const Vector3d& step) const {
  if (!freedom_[v].held) return step;
  return step - step.dot(freedom_[v].planeNormal) * freedom_[v].planeNormal;
}

// The step from where `s` was taken to the surface at `offset` from the wall, in v's plane.
Eigen::Vector3d WallVertices::toWall(std::uint32_t v, const Wall::Sample& s, double offset) const {
  const Vector3d direction = heldStep(v, s.normal);
  const double share = direction.squaredNorm();
  if (share < 0.1) return Vector3d::Zero();
  return (offset - s.offset) / share * direction;
}

// A rim in no known plane is kept as the line that it is: its vertices slide along it to the middle
// between their neighbours.
Eigen::Vector3d WallVertices::alongRim(std::uint32_t v, const Surroundings& s,
                                       double factor) const {
  const Vector3d a = points_[s.alongRim[0]] - points_[v], b = points_[s.alongRim[1]] - points_[v];
  const double toA = a.norm(), toB = b.norm();
  const Vector3d& longer = toA > toB ? a : b;
  const double length = std::max(toA, toB);
  if (!(length > 0.0)) return Vector3d::Zero();
  return factor * std::abs(toA - toB) / (2.0 * length) * longer;
}

void WallVertices::refreshNormals() {
  parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) normals_[v] = wall_.at(points_[v]).normal;
  });
}

// One sweep: towards the neighbours' mean along the wall, then back onto the wall.
void WallVertices::relax(double factor, const Progress& progress) {
  const std::vector<Vector3d> before = points_;
  std::vector<Vector3d> moved = points_, normals = normals_;
  const double longest = 0.25 * wall_.unitMm();
  parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t i = first; i < last; ++i) {
      const auto v = static_cast<std::uint32_t>(i);
      if (freedom_[v].fixed) continue;
      const Surroundings s = surroundings(v);
      if (s.count == 0) continue;
      if (s.alongRim[0] != HalfEdges::none && !freedom_[v].held) {
        moved[v] += alongRim(v, s, factor);
        continue;
      }
      Vector3d step = factor * (s.mean - points_[v]);
      if (!s.insideCap) {
        if (normals_[v].isZero()) continue;
        step -= step.dot(normals_[v]) * normals_[v];
      }
      step = heldStep(v, step);
      if (!s.insideCap) {
        const Wall::Sample sample = wall_.at(points_[v] + step);
        step += toWall(v, sample, 0.0);
        normals[v] = sample.normal;
      }
      const double length = step.norm();
      if (length > longest) step *= longest / length;
      moved[v] += step;
    }
  });
  accept(moved, {}, progress);
  // The wall is sampled once in a sweep: the normal just short of the new place will do.
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (points_[v] != before[v]) normals_[v] = normals[v];
  }
}

WallVertices::Fitness WallVertices::fitness(const Corners& t,
                                            const std::vector<Vector3d>& at) const {
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

// Takes the new places except where a triangle would turn away from the wall or lose its shape: its
// corners stay.
void WallVertices::accept(std::vector<Vector3d>& moved, const Limits& limits,
                          const Progress& progress) {
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
        const bool turned = after.agreement < limits.agreement;
        const bool thin = after.sharpness > limits.sharpness;
        if (!turned && !thin) continue;
        const Fitness now = fitness(t, points_);
        if ((turned && after.agreement < now.agreement) ||
            (thin && after.sharpness > now.sharpness)) {
          bad[i] = 1;
        }
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

// Mean signed distance of the triangles around each vertex from the wall. The mean over the middles
// of the edges integrates a quadratic exactly: it sees the chords cut the curve.
std::vector<double> WallVertices::wallOffsets(const Progress& progress) const {
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

void WallVertices::spread(std::vector<double>& values) const {
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
void WallVertices::restoreOffsets(const std::vector<double>& before, std::vector<double>& given,
                                  const Progress& progress) {
  const std::vector<double> now = wallOffsets(progress);
  const double bound = wall_.offsetLimitMm(params_.wallBoundVoxels);
  std::vector<Vector3d> moved = points_;
  parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
    progress.check();
    for (std::size_t i = first; i < last; ++i) {
      const auto v = static_cast<std::uint32_t>(i);
      if (freedom_[v].fixed || freedom_[v].cap || (!freedom_[v].held && edges_.onRim(v))) continue;
      given[v] = std::clamp(given[v] + before[v] - now[v], -bound, bound);
      const Wall::Sample s = wall_.at(points_[v]);
      if (!s.normal.isZero()) moved[v] += toWall(v, s, given[v]);
    }
  });
  accept(moved, {}, progress);
}

// Vertices that had to stay back for the sake of a triangle's shape go within the bound after all
// unless the triangle would fold over.
void WallVertices::enforceBound(const Progress& progress) {
  const double bound = wall_.offsetLimitMm(params_.wallBoundVoxels);
  for (int round = 0; round < 4; ++round) {
    std::vector<Vector3d> moved = points_;
    parallelFor(0, points_.size(), blockSize, [&](std::size_t first, std::size_t last) {
      progress.check();
      for (std::size_t i = first; i < last; ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        if (freedom_[v].fixed || freedom_[v].cap || (!freedom_[v].held && edges_.onRim(v)))
          continue;
        const Wall::Sample s = wall_.at(points_[v]);
        if (s.normal.isZero() || std::abs(s.offset) <= 1.01 * bound) continue;
        moved[v] += toWall(v, s, std::clamp(s.offset, -bound, bound));
      }
    });
    accept(moved, {0.1, 0.9998}, progress);
  }
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/wall_smoother.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/triangle_shape.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 2048;
/// Rounds of averaging over neighbours, for what belongs to a place rather than to a vertex: the
/// triangles that meet in a vertex before do not meet there after.
constexpr int kSpreads = 8;

/// Of each vertex the mean length of its edges, evened out over the vertices around.
std::vector<double> edgeLengths(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  std::vector<double> lengths(mesh.points.size(), 0.0), sums(lengths.size());
  std::vector<double> counts(lengths.size());
  for (int round = 0; round <= kSpreads; ++round) {
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), 0.0);
    for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
      const std::uint32_t a = sides[i].low, b = sides[i].high;
      const double length = (mesh.points[a] - mesh.points[b]).norm();
      sums[a] += round == 0 ? length : lengths[b];
      sums[b] += round == 0 ? length : lengths[a];
      counts[a] += 1.0;
      counts[b] += 1.0;
    }
    for (std::size_t v = 0; v < lengths.size(); ++v) {
      const double mean = counts[v] > 0.0 ? sums[v] / counts[v] : 0.0;
      lengths[v] = round == 0 ? mean : 0.5 * (lengths[v] + mean);
    }
  }
  return lengths;
}

}  // namespace

WallGround::WallGround(const Wall& wall, const WallPlaces& places)
    : wall_(wall),
      places_(places),
      sizes_(edgeLengths(places.mesh.mesh)),
      normals_(places.mesh.mesh.points.size()) {
  parallelForEach(normals_.size(), blockSize, [&](std::size_t v) {
    normals_[v] = wall_.at(places_.mesh.mesh.points[v]).normal;
  });
}

bool WallGround::allows(std::uint32_t vertex, const Vector3d& normal) const {
  return !places_.mesh.place[vertex].wall || normal.dot(normals_[vertex]) >= wall_.leastTurn();
}

Eigen::Vector3d WallGround::inPlanes(const Place& place, const Vector3d& step) const {
  if (place.planes() == 0) return step;
  const Vector3d& plane = planeNormal(place.firstPlane());
  return step - step.dot(plane) * plane;
}

Eigen::Vector3d WallGround::toWall(const Place& place, const Wall::Sample& s, double offset) const {
  if (onLine(place)) return Vector3d::Zero();
  const Vector3d way = inPlanes(place, s.normal);
  const double share = way.squaredNorm();
  if (share < 0.1) return Vector3d::Zero();
  return (offset - s.offset) / share * way;
}

bool WallGround::land(const Place& place, Vector3d& point, Vector3d& normal, int steps) const {
  if (!place.wall) {
    normal = planeNormal(place.firstPlane());
    return true;
  }
  for (int n = 0; n < steps; ++n) {
    const Wall::Sample sample = wall_.at(point);
    if (sample.normal.isZero()) return false;
    normal = sample.normal;
    if (onLine(place) || std::abs(sample.offset) <= 1e-6 * wall_.unitMm()) break;
    const Vector3d step = toWall(place, sample, 0.0);
    if (step.isZero()) return false;
    point += step;
  }
  return true;
}

WallSmoother::WallSmoother(const WallPlaces& places, const WallGround& ground, const Wall& wall,
                           const SmoothParams& params, const Progress& progress)
    : RemeshWorker(places.mesh, ground, progress, places.fixed, Edits::FlipsOnly),
      places_(places),
      wallGround_(ground),
      wall_(wall),
      params_(params),
      points_(places.mesh.mesh.points) {
  // Without a normal nothing can slide.
  for (std::uint32_t v = 0; v < points_.size(); ++v)
    if (mesh_.normal(v).isZero()) mesh_.lock(v);
}

TriMesh WallSmoother::run() {
  const std::vector<double> before = wallOffsets();
  active_.assign(points_.size(), 1);
  constexpr int sweepsBetweenFlips = 5;
  const int sweeps = params_.iterations;
  for (int done = 0; done < sweeps; done += sweepsBetweenFlips) {
    const bool near = approach();
    relax(std::min(sweepsBetweenFlips, sweeps - done), 0.01);
    // Even valences first, as they let the vertices spread; angles in the end.
    const bool early = done < 2 * sweepsBetweenFlips && done + 2 * sweepsBetweenFlips < sweeps;
    if (flipEdges(early ? FlipBy::Valence : FlipBy::Shape, false) == 0 && !early && near) break;
    progress_.report(0.7 * std::min(done + sweepsBetweenFlips, sweeps) / sweeps);
  }
  repair();
  finish();
  progress_.report(0.9);
  fetch();
  std::vector<double> given(points_.size(), 0.0);
  for (int i = 0; i < 2; ++i) restoreOffsets(before, given);
  enforceBound();
  TriMesh result = places_.mesh.mesh;
  result.points = points_;
  for (std::uint32_t t = 0; t < result.triangles.size(); ++t) result.triangles[t] = corners(t);
  return result;
}

// Brings the rims that are held in planes nearer to the wall, as far as their triangles let them:
// relaxation leaves vertices that start far from it where they are, and of marching cubes those of
// caps do where the wall runs along the plane. True when none went far.
bool WallSmoother::approach() {
  constexpr double longestStep = 0.25, shortStep = 0.02;  // units
  fetch();
  const double longest = longestStep * wall_.unitMm();
  std::vector<Vector3d> moved = points_;
  parallelForEach(points_.size(), blockSize, progress_, [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (freedom(v) == 0 || !mesh_.place(v).wall || mesh_.place(v).planes() == 0) return;
    const Wall::Sample s = wall_.at(points_[v]);
    if (s.normal.isZero()) return;
    const Vector3d step = wallGround_.toWall(mesh_.place(v), s, 0.0);
    const double length = step.norm();
    moved[v] += length > longest ? Vector3d(longest / length * step) : step;
  });
  accept(moved, {});
  bool near = true;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    const double gone = (points_[v] - mesh_.point(v)).norm();
    if (!(gone > 0.0)) continue;
    near = near && gone < shortStep * wall_.unitMm();
    mesh_.set(v, points_[v], wall_.at(points_[v]).normal, mesh_.size(v));
    active_[v] = 1;
  }
  return near;
}

// The places that the engine has given the vertices.
void WallSmoother::fetch() {
  for (std::uint32_t v = 0; v < points_.size(); ++v) points_[v] = mesh_.point(v);
}

WallSmoother::Fitness WallSmoother::fitness(std::uint32_t t,
                                            const std::vector<Vector3d>& at) const {
  const Corners c = corners(t);
  return {agreement(mesh_.patch(t), c, {at[c[0]], at[c[1]], at[c[2]]}),
          largestCosine(at[c[0]], at[c[1]], at[c[2]])};
}

// Takes the new places except where a triangle would turn away from the wall or lose its shape: its
// corners stay.
void WallSmoother::accept(std::vector<Vector3d>& moved, const Limits& limits) {
  const std::size_t count = places_.mesh.mesh.triangles.size();
  std::vector<char> bad(count);
  bool any = true;
  while (any) {
    parallelForEach(count, blockSize, progress_, [&](std::size_t i) {
      bad[i] = 0;
      const auto t = static_cast<std::uint32_t>(i);
      const Corners c = corners(t);
      if (moved[c[0]] == points_[c[0]] && moved[c[1]] == points_[c[1]] &&
          moved[c[2]] == points_[c[2]])
        return;
      const Fitness after = fitness(t, moved);
      const bool turned = after.agreement < limits.agreement;
      const bool thin = after.sharpness > limits.sharpness;
      if (!turned && !thin) return;
      const Fitness now = fitness(t, points_);
      if ((turned && after.agreement < now.agreement) || (thin && after.sharpness > now.sharpness))
        bad[i] = 1;
    });
    any = false;
    for (std::uint32_t t = 0; t < count; ++t) {
      if (bad[t] == 0) continue;
      any = true;
      for (const std::uint32_t v : corners(t)) moved[v] = points_[v];
    }
  }
  points_.swap(moved);
}

// Mean signed distance of the triangles around each vertex from the wall. The mean over the middles
// of the edges integrates a quadratic exactly: it sees the chords cut the curve.
std::vector<double> WallSmoother::wallOffsets() const {
  const std::size_t count = places_.mesh.mesh.triangles.size();
  std::vector<double> volume(count), area(count);
  parallelForEach(count, blockSize, progress_, [&](std::size_t i) {
    const Corners c = corners(static_cast<std::uint32_t>(i));
    if (places_.offWall[c[0]] != 0 || places_.offWall[c[1]] != 0 || places_.offWall[c[2]] != 0)
      return;
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      sum += wall_.at(0.5 * (points_[c[k]] + points_[c[(k + 1) % 3]])).offset / 3.0;
    area[i] = (points_[c[1]] - points_[c[0]]).cross(points_[c[2]] - points_[c[0]]).norm();
    volume[i] = area[i] * sum;
  });
  std::vector<double> volumes(points_.size(), 0.0), areas(points_.size(), 0.0);
  for (std::uint32_t t = 0; t < count; ++t)
    for (const std::uint32_t v : corners(t)) {
      volumes[v] += volume[t];
      areas[v] += area[t];
    }
  for (int round = 0; round < kSpreads; ++round) {
    spread(volumes);
    spread(areas);
  }
  for (std::size_t v = 0; v < volumes.size(); ++v)
    volumes[v] = areas[v] > 0.0 ? volumes[v] / areas[v] : 0.0;
  return volumes;
}

void WallSmoother::spread(std::vector<double>& values) const {
  std::vector<double> next = values;
  parallelForEach(values.size(), blockSize, [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (!mesh_.livesVertex(v)) return;
    const Ring ring = mesh_.ring(v);
    double sum = 0.0;
    for (std::uint32_t k = 0; k < ring.count; ++k) sum += values[ring.vertex[k]];
    next[v] = 0.5 * values[v] + 0.5 * sum / ring.count;
  });
  values.swap(next);
}

// Moves the vertices off the wall by what brings back the volume that the mesh enclosed before,
// place by place, as far as the bound allows.
void WallSmoother::restoreOffsets(const std::vector<double>& before, std::vector<double>& given) {
  const std::vector<double> now = wallOffsets();
  const double bound = wall_.offsetLimitMm(params_.wallBoundVoxels);
  std::vector<Vector3d> moved = points_;
  parallelForEach(points_.size(), blockSize, progress_, [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (!hasOffset(v)) return;
    given[v] = std::clamp(given[v] + before[v] - now[v], -bound, bound);
    const Wall::Sample s = wall_.at(points_[v]);
    if (!s.normal.isZero()) moved[v] += wallGround_.toWall(mesh_.place(v), s, given[v]);
  });
  accept(moved, {});
}

// Vertices that had to stay back for the sake of a triangle's shape go within the bound after all
// unless the triangle would fold over.
void WallSmoother::enforceBound() {
  const double bound = wall_.offsetLimitMm(params_.wallBoundVoxels);
  for (int round = 0; round < 4; ++round) {
    std::vector<Vector3d> moved = points_;
    parallelForEach(points_.size(), blockSize, progress_, [&](std::size_t i) {
      const auto v = static_cast<std::uint32_t>(i);
      if (!hasOffset(v)) return;
      const Wall::Sample s = wall_.at(points_[v]);
      if (s.normal.isZero() || std::abs(s.offset) <= 1.01 * bound) return;
      moved[v] += wallGround_.toWall(mesh_.place(v), s, std::clamp(s.offset, -bound, bound));
    });
    accept(moved, {0.1, 0.9998});
  }
}

}  // namespace angiomesh

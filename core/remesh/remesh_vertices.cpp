// SPDX-License-Identifier: BSD-3-Clause
#include "core/remesh/remesh_vertices.h"

#include <Eigen/Geometry>
#include <bit>

#include "core/base/parallel.h"
#include "core/remesh/remesh_shape.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 512;
constexpr std::size_t cached = 20000;  ///< so many vertices fit into the processor's cache

// Of the wanted length: a step below the first is none; none is longer than the second, and none is
// brought back to the wall by more than the third, which tells that it crossed to another sheet.
constexpr double leastStep = 1e-4, longestStep = 0.5, farthestLanding = 0.3;
constexpr double leastTurn = 0.3;   ///< cosine between the wall's normals before and after a step
constexpr double startReach = 0.3;  ///< units: farther from the wall a vertex starts where it is
// Of the wanted area of a triangle, seen along the normal: below the first it counts as folded, and
// below the second no step may leave it.
constexpr double foldedArea = 0.1, leastArea = 0.02;

struct Flat {
  double x, y;
};

double cross(const Flat& a, const Flat& b) { return a.x * b.y - a.y * b.x; }

// The energy of one triangle with a corner at the origin and the others at a and b: (shape)^2 with
// shape = (sum of squared edges) / (4 sqrt(3) area) >= 1, convex in each corner, plus a term that
// keeps the area near the wanted one.
struct Energy {
  double value = 0.0;
  double gx = 0.0, gy = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

constexpr double evenShape = 6.928203230275509;  // 4 sqrt(3)
constexpr double evenArea = 0.4330127018922193;  // sqrt(3) / 4
constexpr double sizeWeight = 0.15;

double energyAt(const Flat& a, const Flat& b, double wanted) {
  const double area = 0.5 * cross(a, b);
  if (!(area > leastArea * wanted)) return 1e30;
  const double dx = a.x - b.x, dy = a.y - b.y;
  const double f =
      (a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y + dx * dx + dy * dy) / (evenShape * area);
  return f * f + sizeWeight * (area / wanted + wanted / area);
}

void addEnergy(const Flat& a, const Flat& b, double wanted, Energy& e) {
  const double area = 0.5 * cross(a, b);
  const double ax = 0.5 * (a.y - b.y), ay = 0.5 * (b.x - a.x);  // of the area
  const double dx = a.x - b.x, dy = a.y - b.y;
  const double s = a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y + dx * dx + dy * dy;
  const double sx = -2.0 * (a.x + b.x), sy = -2.0 * (a.y + b.y);
  const double inverse = 1.0 / area;
  const double scale = inverse / evenShape;
  const double f = s * scale;
  const double fx = scale * (sx - s * inverse * ax), fy = scale * (sy - s * inverse * ay);
  const double r = 2.0 * s * inverse * inverse;
  const double fxx = scale * (4.0 - 2.0 * inverse * sx * ax + r * ax * ax);
  const double fyy = scale * (4.0 - 2.0 * inverse * sy * ay + r * ay * ay);
  const double fxy = scale * (-inverse * (sx * ay + sy * ax) + r * ax * ay);
  const double slope = sizeWeight * (1.0 / wanted - wanted * inverse * inverse);
  const double bend = sizeWeight * 2.0 * wanted * inverse * inverse * inverse;
  e.value += f * f + sizeWeight * (area / wanted + wanted * inverse);
  e.gx += 2.0 * f * fx + slope * ax;
  e.gy += 2.0 * f * fy + slope * ay;
  e.xx += 2.0 * (fx * fx + f * fxx) + bend * ax * ax;
  e.xy += 2.0 * (fx * fy + f * fxy) + bend * ax * ay;
  e.yy += 2.0 * (fy * fy + f * fyy) + bend * ay * ay;
}

}  // namespace

RemeshVertices::RemeshVertices(const PatchMesh& start, const RemeshGround& ground,
                               const Progress& progress, const std::vector<char>& held, Edits edits)
    : mesh_(start), ground_(ground), progress_(progress), edits_(edits) {
  for (std::uint32_t v = 0; v < held.size(); ++v)
    if (held[v] != 0) {
      mesh_.lock(v);
      partly_ = true;
    }
  if (edits_ == Edits::All && mesh_.vertexSlots() > cached) mesh_.reorder();
  const double reach = startReach * ground_.unitMm();
  parallelForEach(mesh_.vertexSlots(), blockSize, progress_, [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (mesh_.livesVertex(v)) place(v, mesh_.point(v), 4, reach);
  });
}

int RemeshVertices::freedom(std::uint32_t v) const {
  return mesh_.locked(v) ? 0 : mesh_.place(v).freedom();
}

// Puts v where `point` lands; where that is farther than `farthest`, on the point itself.
void RemeshVertices::place(std::uint32_t v, Vector3d point, int steps, double farthest) {
  Vector3d normal = mesh_.normal(v);
  const Vector3d wanted = point;
  const bool landed = ground_.land(mesh_.place(v), point, normal, steps) &&
                      (point - wanted).squaredNorm() < farthest * farthest;
  if (mesh_.locked(v)) point = mesh_.point(v);
  if (!landed) point = wanted;
  mesh_.set(v, point, normal, ground_.sizeAt(v, point));
}

double RemeshVertices::shapeBadness(std::uint32_t t) const {
  return remeshing::badness(mesh_.point(mesh_.origin(3 * t)), mesh_.point(mesh_.origin(3 * t + 1)),
                            mesh_.point(mesh_.origin(3 * t + 2)));
}

// Bad as well where the triangle turns away from the wall: not as bad as an angle below 30 degrees,
// but worse when it is turned over.
double RemeshVertices::faceBadness(std::uint32_t t) const {
  const std::array<std::uint32_t, 3> c{mesh_.origin(3 * t), mesh_.origin(3 * t + 1),
                                       mesh_.origin(3 * t + 2)};
  const std::array<Vector3d, 3> p{mesh_.point(c[0]), mesh_.point(c[1]), mesh_.point(c[2])};
  const double shape = remeshing::badness(p[0], p[1], p[2]);
  const double cosine = agreement(mesh_.patch(t), c, p);
  if (cosine > 0.35) return shape;
  return std::max(shape, cosine > 0.0 ? 1.1 - 0.2 * cosine : 1.5 - cosine);
}

// The smallest cosine between a triangle's normal and the wall's at its corners (the plane's in a
// cap).
double RemeshVertices::agreement(std::uint32_t patch, const std::array<std::uint32_t, 3>& corners,
                                 const std::array<Vector3d, 3>& points) const {
  const Vector3d n = (points[1] - points[0]).cross(points[2] - points[0]);
  const double length = n.norm();
  if (!(length > 0.0)) return -1.0;
  if (patch > 0) return n.dot(ground_.planeNormal(static_cast<int>(patch) - 1)) / length;
  double least = length;
  for (const std::uint32_t v : corners)
    if (mesh_.place(v).wall) least = std::min(least, n.dot(mesh_.normal(v)));
  return least / length;
}

bool RemeshVertices::agrees(std::uint32_t patch, const std::array<std::uint32_t, 3>& corners,
                            const std::array<Vector3d, 3>& points, double least) const {
  return agreement(patch, corners, points) > least;
}

bool RemeshVertices::ringAgrees(std::uint32_t v, const Ring& ring, const Vector3d& point,
                                double least) const {
  for (std::uint32_t i = 0; i < ring.triangles(); ++i) {
    const std::uint32_t a = ring.vertex[i], b = ring.vertex[ring.after(i)];
    const std::uint32_t patch = mesh_.patch(ring.side[i] / 3);
    if (!agrees(patch, {v, a, b}, {point, mesh_.point(a), mesh_.point(b)}, least)) return false;
  }
  return true;
}

// Vertices of one colour share no edge, so they can move at the same time.
void RemeshVertices::colour() {
  constexpr std::uint8_t unset = 255;
  std::vector<std::uint8_t> of(mesh_.vertexSlots(), unset);
  for (auto& list : colours_) list.clear();
  for (std::uint32_t v = 0; v < mesh_.vertexSlots(); ++v) {
    if (!mesh_.livesVertex(v) || freedom(v) == 0) continue;
    std::uint64_t used = 0;
    const Ring ring = mesh_.ring(v);
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      const std::uint8_t c = of[ring.vertex[i]];
      if (c != unset) used |= std::uint64_t{1} << c;
    }
    const auto c = static_cast<std::size_t>(std::countr_one(used));
    of[v] = static_cast<std::uint8_t>(c);
    if (colours_.size() <= c) colours_.resize(c + 1);
    colours_[c].push_back(v);
  }
}

// A Newton step in the tangent plane down the energy of the triangles around v.
bool RemeshVertices::stepOf(std::uint32_t v, const Ring& ring, Vector3d& step) const {
  const Vector3d& p = mesh_.point(v);
  const Vector3d& n = mesh_.normal(v);
  const Vector3d t1 = n.unitOrthogonal(), t2 = n.cross(t1);
  std::array<Flat, EditMesh::ringLimit> flat;
  std::array<double, EditMesh::ringLimit> wanted;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const Vector3d d = mesh_.point(ring.vertex[i]) - p;
    flat[i] = {d.dot(t1), d.dot(t2)};
  }
  Energy e;
  bool folded = false;
  double meanX = 0.0, meanY = 0.0;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const std::uint32_t j = ring.after(i);
    const double g =
        (mesh_.size(v) + mesh_.size(ring.vertex[i]) + mesh_.size(ring.vertex[j])) / 3.0;
    wanted[i] = evenArea * g * g;
    meanX += flat[i].x / ring.count;
    meanY += flat[i].y / ring.count;
    if (cross(flat[i], flat[j]) > foldedArea * wanted[i]) {
      addEnergy(flat[i], flat[j], wanted[i], e);
    } else {
      folded = true;
    }
  }
  if (folded) {
    step = 0.5 * (meanX * t1 + meanY * t2);
    return true;
  }
  const double determinant = e.xx * e.yy - e.xy * e.xy;
  if (!(determinant > 0.0)) return false;
  double x = (e.xy * e.gy - e.yy * e.gx) / determinant;
  double y = (e.xy * e.gx - e.xx * e.gy) / determinant;
  for (int halving = 0; halving < 4; ++halving, x *= 0.5, y *= 0.5) {
    double value = 0.0;
    for (std::uint32_t i = 0; i < ring.count && value < e.value; ++i) {
      const Flat &a = flat[i], &b = flat[ring.after(i)];
      value += energyAt({a.x - x, a.y - y}, {b.x - x, b.y - y}, wanted[i]);
    }
    if (value < e.value) {
      step = x * t1 + y * t2;
      return true;
    }
  }
  return false;
}

// Along a rim or a border between patches: to where both neighbours are as far as they are wanted.
Eigen::Vector3d RemeshVertices::featureStep(std::uint32_t v, const Ring& ring) const {
  std::array<std::uint32_t, 2> ends{};
  std::uint32_t found = 0;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const std::uint32_t h = mesh_.edgeBetween(v, ring.vertex[i]);
    if (!mesh_.isFeature(h)) continue;
    if (found == 2) return Vector3d::Zero();
    ends[found++] = ring.vertex[i];
  }
  if (found != 2) return Vector3d::Zero();
  const Vector3d a = mesh_.point(ends[0]) - mesh_.point(v);
  const Vector3d b = mesh_.point(ends[1]) - mesh_.point(v);
  const double la = a.norm(), lb = b.norm();
  const double ga = mesh_.size(ends[0]) + mesh_.size(v), gb = mesh_.size(ends[1]) + mesh_.size(v);
  const double excess = 0.5 * (la * gb - lb * ga) / (ga + gb);
  if (!(la > 0.0 && lb > 0.0)) return Vector3d::Zero();
  return excess > 0.0 ? Vector3d(excess / la * a) : Vector3d(-excess / lb * b);
}

// True when v moved noticeably.
bool RemeshVertices::relaxVertex(std::uint32_t v) {
  const Ring ring = mesh_.ring(v);
  Vector3d step = Vector3d::Zero();
  if (freedom(v) == 1) {
    step = featureStep(v, ring);
  } else if (ring.open || !stepOf(v, ring, step)) {
    return false;
  }
  step = ground_.along(mesh_.place(v), mesh_.normal(v), step);
  const double length = step.norm(), g = mesh_.size(v);
  if (length < leastStep * g) return false;
  if (length > longestStep * g) step *= longestStep * g / length;
  const Vector3d wanted = mesh_.point(v) + step;
  Vector3d point = wanted, normal = mesh_.normal(v);
  if (!ground_.land(mesh_.place(v), point, normal, 1)) return false;
  if ((point - wanted).norm() > farthestLanding * g) return false;
  if (normal.dot(mesh_.normal(v)) < leastTurn || !ground_.allows(v, normal)) return false;
  if (!ringAgrees(v, ring, point, kLeastAgreement) &&
      ringAgrees(v, ring, mesh_.point(v), kLeastAgreement))
    return false;
  mesh_.set(v, point, normal, ground_.sizeAt(v, point));
  return true;
}

// Sweeps over the vertices that still move by more than `settled` wanted lengths, or whose
// neighbours do. Returns how many moved in the last sweep.
std::size_t RemeshVertices::relax(int sweeps, double settled) {
  colour();
  std::size_t count = 0;
  active_.resize(mesh_.vertexSlots(), 1);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    moved_.assign(mesh_.vertexSlots(), 0);
    for (const auto& list : colours_)
      parallelForEach(list.size(), blockSize, progress_, [&](std::size_t i) {
        const std::uint32_t v = list[i];
        if (active_[v] == 0) return;
        const Vector3d before = mesh_.point(v);
        if (relaxVertex(v) && (mesh_.point(v) - before).norm() > settled * mesh_.size(v))
          moved_[v] = 1;
      });
    std::fill(active_.begin(), active_.end(), std::uint8_t{0});
    count = 0;
    for (std::uint32_t h = 0; h < mesh_.halfEdgeSlots(); ++h) {
      if (mesh_.origin(h) == EditMesh::none) continue;
      if (moved_[mesh_.origin(h)] != 0) active_[mesh_.target(h)] = active_[mesh_.origin(h)] = 1;
    }
    for (const std::uint8_t m : moved_) count += m;
    if (count == 0) break;
  }
  return count;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/remesh/remesh_edges.h"

#include "core/base/parallel.h"
#include "core/mesh/triangle_shape.h"
#include "core/remesh/remesh_shape.h"

namespace angiomesh {
namespace {

// Botsch and Kobbelt's 4/3 and 4/5, brought down so that the mean is 1.
constexpr double longEdge = 1.30, shortEdge = 0.78;
/// Cosines between two triangles, and between a triangle and the wall, that are no loss.
constexpr double slightBend = 0.85, slightLean = 0.7;

// Badness (see remeshing::badness()): below the first a flip has nothing to mend, and up to the
// second one by valence may go, as relaxation evens it out.
constexpr double mendable = 0.5, relaxable = 1.6;
// What a flip has to gain in badness: more where valences say nothing, so that flips come to rest.
constexpr double shapeGain = 1e-3, valenceGain = 0.05;
// Relaxation ends where nothing moves by more than this, in wanted lengths.
constexpr double settled = 0.02, settledInTheEnd = 0.01;
// Resizing ends with a round that changes less than one in so many triangles.
constexpr std::size_t rareChange = 300;

int square(int x) { return x * x; }

}  // namespace

// The length of an edge in wanted lengths.
double RemeshEdges::stretch(std::uint32_t h) const {
  const std::uint32_t u = mesh_.origin(h), v = mesh_.target(h);
  return 2.0 * (mesh_.point(v) - mesh_.point(u)).norm() / (mesh_.size(u) + mesh_.size(v));
}

bool RemeshEdges::flipAgrees(std::uint32_t h) const {
  const std::uint32_t u = mesh_.origin(h), v = mesh_.target(h), a = mesh_.apex(h),
                      b = mesh_.apex(mesh_.twin(h));
  const Vector3d &pu = mesh_.point(u), &pv = mesh_.point(v), &pa = mesh_.point(a),
                 &pb = mesh_.point(b);
  const std::uint32_t patch = mesh_.patch(h / 3);
  return agrees(patch, {u, b, a}, {pu, pb, pa}, kChosenAgreement) &&
         agrees(patch, {v, a, b}, {pv, pa, pb}, kChosenAgreement);
}

// Whether a flip leaves a pair that bends as little as before, and agrees with the wall as well: of
// a thin vessel of few vertices another one would cut off a part.
bool RemeshEdges::flipKeepsWall(std::uint32_t h) const {
  const std::uint32_t u = mesh_.origin(h), v = mesh_.target(h), a = mesh_.apex(h),
                      b = mesh_.apex(mesh_.twin(h));
  const Vector3d &pu = mesh_.point(u), &pv = mesh_.point(v), &pa = mesh_.point(a),
                 &pb = mesh_.point(b);
  const double bend = unitNormal(pu, pv, pa).dot(unitNormal(pv, pu, pb));
  if (unitNormal(pu, pb, pa).dot(unitNormal(pv, pa, pb)) < std::min(slightBend, bend)) return false;
  const std::uint32_t patch = mesh_.patch(h / 3);
  const double least = std::min({slightLean, agreement(patch, {u, v, a}, {pu, pv, pa}),
                                 agreement(patch, {v, u, b}, {pv, pu, pb})});
  return agreement(patch, {u, b, a}, {pu, pb, pa}) >= least &&
         agreement(patch, {v, a, b}, {pv, pa, pb}) >= least;
}

// By valence: towards 6 (4 on a rim) where that leaves triangles that relaxation can even out. By
// shape: where the worse of the two triangles gets better.
bool RemeshEdges::worthFlipping(std::uint32_t h, FlipBy by) const {
  const std::uint32_t o = mesh_.twin(h);
  if (o == EditMesh::none || mesh_.isFeature(h)) return false;
  const std::uint32_t u = mesh_.origin(h), v = mesh_.target(h), a = mesh_.apex(h),
                      b = mesh_.apex(o);
  const Vector3d &pu = mesh_.point(u), &pv = mesh_.point(v), &pa = mesh_.point(a),
                 &pb = mesh_.point(b);
  const double now = std::max(remeshing::badness(pu, pv, pa), remeshing::badness(pv, pu, pb));
  if (by == FlipBy::Shape && now < mendable) return false;
  const auto excess = [&](std::uint32_t w, int change) {
    const int valence = static_cast<int>(mesh_.valence(w)) + change;
    return square(valence - (mesh_.onRim(w) ? 4 : 6));
  };
  bool worth = false;
  const double then = std::max(remeshing::badness(pu, pb, pa), remeshing::badness(pv, pa, pb));
  if (by == FlipBy::Valence) {
    const int before = excess(u, 0) + excess(v, 0) + excess(a, 0) + excess(b, 0);
    const int after = excess(u, -1) + excess(v, -1) + excess(a, 1) + excess(b, 1);
    worth = after < before ? then < std::max(relaxable, now)
                           : after == before && then < now - valenceGain;
  } else {
    worth = then < now - shapeGain;
  }
  return worth && mesh_.canFlip(h) && flipAgrees(h) && (edits_ == Edits::All || flipKeepsWall(h));
}

// Where `all` is false, only edges of active vertices are looked at.
std::size_t RemeshEdges::flipEdges(FlipBy by, bool all) {
  std::size_t count = 0;
  active_.resize(mesh_.vertexSlots(), 1);
  for (std::uint32_t h = 0; h < mesh_.halfEdgeSlots(); ++h) {
    if (h % 65536 == 0) progress_.check();
    const std::uint32_t u = mesh_.origin(h);
    if (u == EditMesh::none || mesh_.twin(h) < h || mesh_.twin(h) == EditMesh::none) continue;
    if (!all && active_[u] == 0 && active_[mesh_.target(h)] == 0) continue;
    if (!worthFlipping(h, by)) continue;
    for (const std::uint32_t v : {u, mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.twin(h))})
      active_[v] = 1;
    mesh_.flip(h);
    ++count;
  }
  return count;
}

// Has the next sweep look at v and its neighbours.
void RemeshEdges::activate(std::uint32_t v) {
  active_.resize(mesh_.vertexSlots(), 1);
  const Ring ring = mesh_.ring(v);
  active_[v] = 1;
  for (std::uint32_t i = 0; i < ring.count; ++i) active_[ring.vertex[i]] = 1;
}

Place RemeshEdges::splitPlace(std::uint32_t h) const {
  if (mesh_.isFeature(h)) return mesh_.place(mesh_.origin(h)).shared(mesh_.place(mesh_.target(h)));
  const std::uint16_t patch = mesh_.patch(h / 3);
  return patch == 0 ? Place::onWall() : Place::inPlane(patch - 1);
}

// Returns the new vertex, none where it cannot land.
std::uint32_t RemeshEdges::splitEdge(std::uint32_t h) {
  const std::uint32_t u = mesh_.origin(h), v = mesh_.target(h), o = mesh_.twin(h);
  if (mesh_.locked(u) || mesh_.locked(v) || mesh_.locked(mesh_.apex(h))) return EditMesh::none;
  if (mesh_.valence(mesh_.apex(h)) + 2 >= EditMesh::ringLimit) return EditMesh::none;
  if (o != EditMesh::none &&
      (mesh_.locked(mesh_.apex(o)) || mesh_.valence(mesh_.apex(o)) + 2 >= EditMesh::ringLimit))
    return EditMesh::none;
  const Place where = splitPlace(h);
  if (where.freedom() == 0) return EditMesh::none;
  Vector3d point = 0.5 * (mesh_.point(u) + mesh_.point(v));
  Vector3d normal = mesh_.normal(u) + mesh_.normal(v);
  const double length = (mesh_.point(u) - mesh_.point(v)).norm();
  const Vector3d middle = point;
  if (!ground_.land(where, point, normal, 3) || (point - middle).norm() > 0.5 * length)
    return EditMesh::none;
  const std::uint32_t m = mesh_.split(h, where);
  mesh_.set(m, point, normal, ground_.sizeAt(m, point));
  activate(m);
  return m;
}

// Whether the origin of h can go into its target, and where the two would meet.
bool RemeshEdges::collapseFits(std::uint32_t h, double longest, Vector3d& point) const {
  const std::uint32_t u = mesh_.origin(h), v = mesh_.target(h);
  const Place from = mesh_.place(u), to = mesh_.place(v);
  if (!to.within(from) || mesh_.locked(u) || mesh_.locked(v) || freedom(u) == 0) return false;
  point = mesh_.point(v);
  if (from == to) {
    Vector3d normal = mesh_.normal(v);
    Vector3d middle = 0.5 * (mesh_.point(u) + mesh_.point(v));
    if (ground_.land(to, middle, normal, 2) && normal.dot(mesh_.normal(v)) > 0.5) point = middle;
  }
  for (const std::uint32_t w : {u, v}) {
    const Ring ring = mesh_.ring(w);
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      const std::uint32_t a = ring.vertex[i];
      if (a == u || a == v) continue;
      const double wanted = 0.5 * (mesh_.size(a) + mesh_.size(v));
      if ((mesh_.point(a) - point).norm() > longest * wanted) return false;
      const std::uint32_t b = ring.vertex[ring.after(i)];
      if (ring.side[i] == EditMesh::none || b == u || b == v) continue;
      const std::uint32_t patch = mesh_.patch(ring.side[i] / 3);
      const std::array<std::uint32_t, 3> corners{v, a, b};
      const Vector3d &pa = mesh_.point(a), &pb = mesh_.point(b);
      if (!agrees(patch, corners, {point, pa, pb}, kLeastAgreement) &&
          agrees(patch, {w, a, b}, {mesh_.point(w), pa, pb}, kLeastAgreement))
        return false;
    }
  }
  return mesh_.canCollapse(h);
}

bool RemeshEdges::collapseEdge(std::uint32_t h, double longest) {
  Vector3d point;
  if (!collapseFits(h, longest, point)) {
    h = mesh_.twin(h);
    if (h == EditMesh::none || !collapseFits(h, longest, point)) return false;
  }
  const std::uint32_t v = mesh_.target(h);
  mesh_.collapse(h);
  place(v, point, 1, 0.3 * mesh_.size(v));
  activate(v);
  return true;
}

// Only edges that are the longest of both their triangles: splitting the long sides of slivers
// would make more of them.
std::size_t RemeshEdges::splitLong() {
  std::size_t count = 0;
  const std::uint32_t slots = mesh_.halfEdgeSlots();
  const auto longestOf = [&](std::uint32_t h, double s) {
    return stretch(EditMesh::next(h)) <= s && stretch(EditMesh::previous(h)) <= s;
  };
  for (std::uint32_t h = 0; h < slots; ++h) {
    if (h % 65536 == 0) progress_.check();
    const std::uint32_t o = mesh_.twin(h);
    if (mesh_.origin(h) == EditMesh::none || o < h) continue;
    const double s = stretch(h);
    if (s < longEdge || !longestOf(h, s) || (o != EditMesh::none && !longestOf(o, s))) continue;
    if (splitEdge(h) != EditMesh::none) ++count;
  }
  return count;
}

std::size_t RemeshEdges::collapseShort() {
  std::size_t count = 0;
  for (std::uint32_t h = 0; h < mesh_.halfEdgeSlots(); ++h) {
    if (h % 65536 == 0) progress_.check();
    if (mesh_.origin(h) == EditMesh::none) continue;
    if (stretch(h) < shortEdge && collapseEdge(h, longEdge)) ++count;
  }
  return count;
}

void RemeshEdges::resize() {
  constexpr int rounds = 16;
  std::size_t ordered = mesh_.vertexSlots();
  active_.assign(mesh_.vertexSlots(), 1);
  for (int round = 0; round < rounds; ++round) {
    const std::size_t changed = collapseShort() + splitLong();
    // New vertices are far from their neighbours in memory.
    if (mesh_.vertexSlots() > 2 * ordered || rareChange * changed < mesh_.halfEdgeSlots() / 3) {
      mesh_.reorder();
      ordered = mesh_.vertexSlots();
      active_.assign(mesh_.vertexSlots(), 1);
    }
    flipEdges(FlipBy::Valence, false);
    relax(2, settled);
    progress_.report(0.6 * (round + 1) / rounds);
    if (rareChange * changed < mesh_.halfEdgeSlots() / 3) break;
  }
}

void RemeshEdges::even() {
  active_.assign(mesh_.vertexSlots(), 1);
  flipEdges(FlipBy::Valence, true);
  for (int round = 0; round < 4; ++round) {
    relax(4, settled);
    if (flipEdges(round < 2 ? FlipBy::Valence : FlipBy::Shape, false) == 0 && round > 1) break;
  }
  relax(4, settledInTheEnd);
}

}  // namespace angiomesh

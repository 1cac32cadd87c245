// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/advancing_front.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/exact_math.h"
#include "core/front/fill_loop.h"
#include "core/mesh/triangle_shape.h"

namespace angiomesh {
namespace {

constexpr double kRoom = 1.05;        ///< of the triangles that are expected
constexpr double kShapeSteps = 20.0;  ///< so many for a factor of 2 in length
/// Lengths may grow by at least so much per mm, however slowly the sizes do.
constexpr double kLeastGrowth = 0.2;
/// How far a free triangle looks for the fronts, of the longest length about it: as far as what its
/// corner and sides have to be clear of.
constexpr double kFreeReach = 1.8;
// How far a connection looks, and the second time, of the longest length about it, from a place so
// far ahead of the base.
constexpr double kConnectionReach = 1.5, kRelaxedReach = 3.0, kAhead = 0.4;
/// A candidate lower than this over the base, of its length, makes no triangle.
constexpr double kLeastRise = 1e-9;
/// The least cosine between the triangles after a flip and those before.
constexpr double kFlipAgreement = 0.5;
constexpr double kFlipGain = 1e-9;  ///< of a cosine, so that no edge flips to and fro

}  // namespace

void AdvancingFront::expect(double triangles) {
  constexpr double most = 1 << 25;
  const auto count = static_cast<std::size_t>(std::clamp(kRoom * triangles, 0.0, most));
  triangles_.reserve(count);
  origins_.reserve(count);
  const std::size_t vertices = count / 2;
  vertices_.reserve(vertices);
  spacing_.reserve(vertices);
  leaving_.reserve(vertices);
  seen_.reserve(vertices);
  used_.reserve(vertices);
  all_.reserve(vertices);
}

void AdvancingFront::push(std::uint32_t id, Class kind, double shape) {
  Edge& e = edges_[id];
  e.kind = kind;
  ++e.stamp;
  // Shapes are told apart in steps; equal ones go by age, so that the front stays round.
  const auto rank = static_cast<std::uint64_t>(std::clamp(kShapeSteps * shape, 0.0, 1e6));
  const std::uint64_t key = (static_cast<std::uint64_t>(kind) << 60U) | (rank << 32U) |
                            static_cast<std::uint64_t>(age_++);
  if (heap_.size() > 4 * (edges_.size() - freeEdges_.size()) + 4096) dropVoid();
  heap_.push_back({key, id, e.stamp});
  std::push_heap(heap_.begin(), heap_.end());
}

// Without the entries that changes have made void the heap stays as small as the front.
void AdvancingFront::dropVoid() {
  std::erase_if(heap_, [this](const HeapEntry& entry) { return !valid(entry); });
  std::make_heap(heap_.begin(), heap_.end());
}

// The neighbourhood of the edge has changed. There is never more room than before: an edge that
// had none for a free triangle has to connect.
void AdvancingFront::refresh(std::uint32_t id) {
  const Edge& e = edges_[id];
  if (e.kind != Class::Free) {
    push(id, Class::Connection, 0.0);
    return;
  }
  const double length = (vertices_[e.to].point - vertices_[e.from].point).norm();
  const double wanted = 0.5 * (vertices_[e.from].length + vertices_[e.to].length);
  const double octaves = std::numbers::log2e * portableLog(std::max(length, 1e-300) / wanted);
  push(id, Class::Free, std::fabs(octaves));
}

void AdvancingFront::refreshAround(std::uint32_t added) {
  refresh(added);
  refresh(edges_[added].previous);
  refresh(edges_[added].next);
}

void AdvancingFront::startAt(const Triangle& triangle) {
  addTriangle(triangle, FaceOrigin::Front);
  startAlong({triangle[2], triangle[1], triangle[0]});
}

void AdvancingFront::startAlong(const std::vector<std::uint32_t>& loop) {
  std::vector<std::uint32_t> ids;
  ids.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
    if (!used_.has(to, from)) used_.set(to, from, EdgeMap::rim);
    ids.push_back(newEdge(from, to));
  }
  for (std::size_t i = 0; i < ids.size(); ++i) join(ids[i], ids[(i + 1) % ids.size()]);
  for (const std::uint32_t id : ids) refresh(id);
}

void AdvancingFront::run(const Progress& progress) {
  std::size_t rounds = 0;
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const HeapEntry top = heap_.back();
    heap_.pop_back();
    if (!valid(top)) continue;
    if (++rounds % 4096 == 0) progress.check();
    switch (edges_[top.edge].kind) {
      case Class::Free:
        if (!tryFree(top.edge)) push(top.edge, Class::Connection, 0.0);
        break;
      case Class::Connection:
        if (!tryConnection(top.edge, false)) push(top.edge, Class::Forced, 0.0);
        break;
      case Class::Forced:
        if (!tryConnection(top.edge, true)) push(top.edge, Class::Stuck, 0.0);
        break;
      case Class::Stuck:
        break;
    }
  }
}

bool AdvancingFront::tryFree(std::uint32_t id) {
  const Edge e = edges_[id];
  const Frame frame = frameOf(e);
  const ApexWish wish = wishFor(frame, id);
  if (!(wish.height > 0.0)) return false;
  FrontPoint apex;
  if (!surface_.turn(vertices_[e.from], vertices_[e.to], wish, apex)) return false;
  // Sizes grow along the front no faster than they may, also from a rim that is finer than the
  // wall.
  const double growth = std::max(surface_.slope(), kLeastGrowth);
  for (const std::uint32_t v : {e.from, e.to})
    apex.length = std::min(apex.length,
                           vertices_[v].length + growth * (apex.point - vertices_[v].point).norm());
  const Eigen::Vector3d centre =
      (vertices_[e.from].point + vertices_[e.to].point + apex.point) / 3.0;
  const double reach = std::max({apex.length, wish.height, vertices_[e.from].length});
  const double spacing = std::min({spacing_[e.from], spacing_[e.to], apex.length});
  collect(frame, centre, kFreeReach * reach, spacing, false);
  if (!clearAround(e, apex)) return false;
  if (!legal(frame, id, none, frame.flat(apex.point), false)) return false;
  if (meshedAt(apex)) return false;
  emit(id, addVertex(apex), none, FaceOrigin::Front);
  return true;
}

bool AdvancingFront::tryConnection(std::uint32_t id, bool relaxed) {
  const Edge e = edges_[id];
  const Frame frame = frameOf(e);
  const Eigen::Vector3d& a = vertices_[e.from].point;
  const Eigen::Vector3d& b = vertices_[e.to].point;
  const double length = (b - a).norm();
  const double wanted = std::max({length, vertices_[e.from].length, vertices_[e.to].length});
  struct Candidate {
    double cosine;
    std::uint32_t vertex;
    Eigen::Vector2d at;
  };
  std::vector<Candidate> candidates;
  for (const double reach : {kConnectionReach, kRelaxedReach}) {
    if (reach == kRelaxedReach && !relaxed) break;
    collect(frame, 0.5 * (a + b) + kAhead * wanted * frame.v, reach * wanted,
            std::min(spacing_[e.from], spacing_[e.to]), relaxed);
    const Eigen::Vector2d a2 = frame.flat(a), b2 = frame.flat(b);
    candidates.clear();
    for (const Near& near : near_) {
      if (near.vertex == e.from || near.vertex == e.to) continue;
      if (near.at.y() <= kLeastRise * length) continue;
      // The vertex that sees the base under the largest angle has an empty circumcircle.
      const Eigen::Vector2d p = (a2 - near.at).normalized(), q = (b2 - near.at).normalized();
      candidates.push_back({p.dot(q), near.vertex, near.at});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& p, const Candidate& q) {
      return p.cosine != q.cosine ? p.cosine < q.cosine : p.vertex < q.vertex;
    });
    for (const Candidate& c : candidates) {
      if (!edgesUsable(id, c.vertex)) continue;
      const std::uint32_t corner = openCorner(frame, id, c.vertex, c.at);
      if (corner == none) continue;
      if (!legal(frame, id, c.vertex, c.at, relaxed)) continue;
      emit(id, c.vertex, corner, FaceOrigin::Front);
      return true;
    }
  }
  return false;
}

// Replaces the base by the two new edges. `corner` is the front edge that leaves the apex on the
// side where the triangle comes in; none for a new vertex.
void AdvancingFront::emit(std::uint32_t id, std::uint32_t apex, std::uint32_t corner,
                          FaceOrigin origin) {
  const Edge e = edges_[id];
  const std::uint32_t t = addTriangle({e.from, e.to, apex}, origin);
  const bool earNext = corner != none && edges_[e.next].to == apex && edges_[e.next].next == corner;
  const bool earPrevious = corner != none && e.previous == corner;
  if (earNext && earPrevious) {
    dropEdge(e.next);
    dropEdge(e.previous);
    dropEdge(id);
  } else if (earNext) {
    const std::uint32_t added = newEdge(e.from, apex);
    join(e.previous, added);
    join(added, edges_[e.next].next);
    dropEdge(e.next);
    dropEdge(id);
    refreshAround(added);
  } else if (earPrevious) {
    const std::uint32_t added = newEdge(apex, e.to);
    join(edges_[e.previous].previous, added);
    join(added, e.next);
    dropEdge(e.previous);
    dropEdge(id);
    refreshAround(added);
  } else {
    const std::uint32_t into = newEdge(e.from, apex);
    const std::uint32_t out = newEdge(apex, e.to);
    if (corner == none) {
      join(into, out);
    } else {
      join(edges_[corner].previous, out);
      join(into, corner);
    }
    join(e.previous, into);
    join(out, e.next);
    dropEdge(id);
    refreshAround(into);
    refreshAround(out);
  }
  flipAround(t);
}

// Flips edges of the new triangle where that enlarges the smaller of the two least angles and both
// new triangles look the same way as the old ones.
void AdvancingFront::flipAround(std::uint32_t triangle) {
  const Triangle t = triangles_[triangle];
  for (std::size_t k = 0; k < 3; ++k)
    if (flip(t[k], t[(k + 1) % 3])) return;
}

bool AdvancingFront::flip(std::uint32_t from, std::uint32_t to) {
  const std::uint32_t left = used_.find(from, to), right = used_.find(to, from);
  if (left >= EdgeMap::rim || right >= EdgeMap::rim) return false;
  const auto third = [&](std::uint32_t t) {
    for (const std::uint32_t v : triangles_[t])
      if (v != from && v != to) return v;
    return none;
  };
  const std::uint32_t p = third(left), q = third(right);
  if (p == q || used_.has(p, q) || used_.has(q, p)) return false;
  const auto& a = vertices_[from].point;
  const auto& b = vertices_[to].point;
  const auto& c = vertices_[p].point;
  const auto& d = vertices_[q].point;
  const double before = std::max(largestCosine(a, b, c), largestCosine(b, a, d));
  const double after = std::max(largestCosine(a, d, c), largestCosine(d, b, c));
  if (!(after < before - kFlipGain)) return false;
  const Eigen::Vector3d n1 = (b - a).cross(c - a), n2 = (a - b).cross(d - b);
  const Eigen::Vector3d m1 = (d - a).cross(c - a), m2 = (b - d).cross(c - d);
  const Eigen::Vector3d n = n1 + n2;
  if (m1.dot(n) <= kFlipAgreement * m1.norm() * n.norm() ||
      m2.dot(n) <= kFlipAgreement * m2.norm() * n.norm())
    return false;
  used_.set(from, to, none);
  used_.set(to, from, none);
  triangles_[left] = {from, q, p};
  triangles_[right] = {q, to, p};
  for (const std::uint32_t t : {left, right})
    for (std::size_t k = 0; k < 3; ++k) used_.set(triangles_[t][k], triangles_[t][(k + 1) % 3], t);
  return true;
}

std::size_t AdvancingFront::close() {
  std::size_t failed = 0;
  for (std::uint32_t id = 0; id < edges_.size(); ++id) {
    if (!edges_[id].alive) continue;
    std::vector<std::uint32_t> loop, members;
    for (std::uint32_t h = id;;) {
      loop.push_back(edges_[h].from);
      members.push_back(h);
      h = edges_[h].next;
      if (h == id) break;
    }
    if (loop.size() > 2) {
      const auto filling = fillLoop(loop, vertices_, [this](std::uint32_t a, std::uint32_t b) {
        return used_.has(a, b) || used_.has(b, a);
      });
      if (filling.empty()) ++failed;
      for (const Triangle& t : filling) addTriangle(t, FaceOrigin::Closing);
    }
    for (const std::uint32_t h : members) dropEdge(h);
  }
  return failed;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/front_rules.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mesh/predicates.h"

namespace angiomesh {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Shares of the wanted edge length. A free corner keeps this distance from the fronts' vertices
// and edges, and its edges keep it from the vertices: what is left open is then closed by
// triangles with no angle much below 30 degrees.
constexpr double kClearOfVertex = 0.72, kClearOfEdge = 0.5, kEdgeClearOfVertex = 0.45;
constexpr double kClearOfMesh = 0.6;
/// New edges are at most so many times longer than those they start from.
constexpr double kLongerThanBase = 1.3;

/// What is on one sheet of the surface: the least cosine between normals, and the largest sine of
/// the way out of the base's plane. Relaxed is what is asked for where nothing else is left: a bend
/// by a little more than a right angle, any way out.
struct SheetLimits {
  double agreement, steepness;
};
constexpr SheetLimits kSheet{0.2, 0.7}, kRelaxedSheet{-0.1, 1.2};
/// The least cosine between a new triangle and the normals at its corners.
constexpr double kTriangleAgreement = 0.3, kRelaxedTriangleAgreement = -0.2;

// Vertices lie closer than wanted by up to this share, as edges differ in length.
constexpr double kClosest = 0.7;
// Of the radius of a search: bounds its work where sizes may change at any rate.
constexpr double kFinestShare = 0.05;

// The corner that is wished for: its sides are at most so many times longer or shorter than the
// base; its foot stays off the base's ends, and its height is half the base at least, so that no
// angle comes to be obtuse; the even share of a corner moves the height by less than a third.
constexpr double kSideToBase = 1.6, kFootOffEnds = 0.1, kLeastHeight = 0.5;
constexpr double kLowered = 0.7, kRaised = 1.3;
// Tangents of half a corner: from 1.5 to 2.7 radians there is room for two triangles.
constexpr double kLeastForTwo = 0.9315964599440725, kMostForTwo = 4.455221759562705;
constexpr double kOfEvenTriangle = 1.7320508075688772;

double squaredDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (p - a - t * ab).squaredNorm();
}

// Whether the open segments have one point in common (exact).
bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const int abc = orient2d(a, b, c), abd = orient2d(a, b, d);
  if (abc * abd > 0) return false;
  const int cda = orient2d(c, d, a), cdb = orient2d(c, d, b);
  return cda * cdb <= 0 && (abc != 0 || abd != 0);
}

// Whether the direction of d lies strictly inside the sector at q that runs counter-clockwise from
// z to y.
bool inSector(const Vector2d& q, const Vector2d& z, const Vector2d& y, const Vector2d& d) {
  if (orient2d(q, z, y) > 0) return orient2d(q, z, d) > 0 && orient2d(q, d, y) > 0;
  return !(orient2d(q, y, d) >= 0 && orient2d(q, d, z) >= 0);
}

}  // namespace

std::uint32_t FrontRules::addVertex(const FrontPoint& point, double spacing) {
  vertices_.push_back(point);
  spacing_.push_back(spacing);
  leaving_.push_back(none);
  const auto id = static_cast<std::uint32_t>(vertices_.size() - 1);
  all_.insert(id, point.point, spacing);
  return id;
}

std::uint32_t FrontRules::newEdge(std::uint32_t from, std::uint32_t to) {
  std::uint32_t id = 0;
  if (freeEdges_.empty()) {
    id = static_cast<std::uint32_t>(edges_.size());
    edges_.emplace_back();
  } else {
    id = freeEdges_.back();
    freeEdges_.pop_back();
  }
  Edge& e = edges_[id];
  e.from = from;
  e.to = to;
  e.next = e.previous = none;
  e.kind = Class::Free;
  e.alive = true;
  e.nextLeaving = leaving_[from];
  if (leaving_[from] == none) grid_.insert(from, vertices_[from].point, spacing_[from]);
  leaving_[from] = id;
  return id;
}

void FrontRules::dropEdge(std::uint32_t id) {
  Edge& e = edges_[id];
  std::uint32_t* link = &leaving_[e.from];
  while (*link != id) link = &edges_[*link].nextLeaving;
  *link = e.nextLeaving;
  if (leaving_[e.from] == none) grid_.remove(e.from, vertices_[e.from].point, spacing_[e.from]);
  e.alive = false;
  ++e.stamp;
  freeEdges_.push_back(id);
}

void FrontRules::join(std::uint32_t before, std::uint32_t after) {
  edges_[before].next = after;
  edges_[after].previous = before;
}

std::uint32_t FrontRules::addTriangle(const Triangle& t, FaceOrigin origin) {
  const auto id = static_cast<std::uint32_t>(triangles_.size());
  triangles_.push_back(t);
  origins_.push_back(origin);
  for (std::size_t k = 0; k < 3; ++k) used_.set(t[k], t[(k + 1) % 3], id);
  return id;
}

FrontRules::Frame FrontRules::frameOf(const Edge& e) const {
  const FrontPoint& a = vertices_[e.from];
  const FrontPoint& b = vertices_[e.to];
  Frame f;
  f.origin = 0.5 * (a.point + b.point);
  f.u = (b.point - a.point).normalized();
  Vector3d n = a.normal + b.normal;
  n -= n.dot(f.u) * f.u;
  f.n = n.normalized();
  f.v = f.n.cross(f.u);
  return f;
}

// The front's vertices and edges on the frame's sheet of the surface. Other sheets are told by
// their normals, and by their distance from the frame's plane.
void FrontRules::collect(const Frame& frame, const Vector3d& centre, double radius, double spacing,
                         bool relaxed) {
  near_.clear();
  nearEdges_.clear();
  seen_.resize(vertices_.size(), 0);
  ++collected_;
  const SheetLimits& sheet = relaxed ? kRelaxedSheet : kSheet;
  const double shortest =
      std::max(kClosest * (spacing - surface_.slope() * radius), kFinestShare * radius);
  grid_.forEachNear(centre, radius, shortest, [&](std::uint32_t id) {
    const FrontPoint& p = vertices_[id];
    if (p.normal.dot(frame.n) < sheet.agreement) return;
    const Vector3d d = p.point - frame.origin;
    if (std::fabs(d.dot(frame.n)) > sheet.steepness * d.norm()) return;
    seen_[id] = collected_;
    near_.push_back({id, frame.flat(p.point)});
  });
  for (const Near& near : near_) {
    for (std::uint32_t h = leaving_[near.vertex]; h != none; h = edges_[h].nextLeaving) {
      nearEdges_.push_back({h, near.at, frame.flat(vertices_[edges_[h].to].point)});
      const std::uint32_t in = edges_[h].previous;
      const std::uint32_t before = edges_[in].from;
      if (seen_[before] != collected_)
        nearEdges_.push_back({in, frame.flat(vertices_[before].point), near.at});
    }
  }
}

// The tangent of half the angle of the unmeshed sector between the front edges in -> v -> out;
// negative where that is more than a half turn.
double FrontRules::halfCornerTangent(std::uint32_t in, std::uint32_t out) const {
  const FrontPoint& v = vertices_[edges_[out].from];
  const Vector3d z = vertices_[edges_[out].to].point - v.point;
  const Vector3d y = vertices_[edges_[in].from].point - v.point;
  const double sine = z.cross(y).dot(v.normal), cosine = z.dot(y);
  return (std::sqrt(sine * sine + cosine * cosine) - cosine) / sine;
}

// Both new edges as long as wanted at their ends; where a corner of the front leaves room for
// two triangles, they share it evenly.
ApexWish FrontRules::wishFor(const Frame& frame, std::uint32_t id) const {
  const Edge& e = edges_[id];
  const FrontPoint& a = vertices_[e.from];
  const FrontPoint& b = vertices_[e.to];
  const Vector3d ab = b.point - a.point;
  const double base = ab.norm();
  const auto bounded = [base](double s) {
    return std::clamp(s, base / kSideToBase, kSideToBase * base);
  };
  double sa = bounded(a.length), sb = bounded(b.length);
  ApexWish wish;
  for (int round = 0; round < 2; ++round) {
    wish.along = std::clamp((base * base + sa * sa - sb * sb) / (2.0 * base), kFootOffEnds * base,
                            (1.0 - kFootOffEnds) * base);
    wish.height = std::sqrt(
        std::max(sa * sa - wish.along * wish.along, kLeastHeight * kLeastHeight * base * base));
    if (round == 1) break;
    const double there = surface_.lengthAt(a.point + wish.along * frame.u + wish.height * frame.v);
    sa = bounded(0.5 * (a.length + there));
    sb = bounded(0.5 * (b.length + there));
  }
  const auto share = [](double tangent) {
    return tangent > kLeastForTwo && tangent < kMostForTwo ? tangent : kOfEvenTriangle;
  };
  const double ta = share(halfCornerTangent(e.previous, id));
  const double tb = share(halfCornerTangent(id, e.next));
  const double along = base * tb / (ta + tb);
  const double height = along * ta;
  wish.along = 0.5 * (wish.along + along);
  wish.height =
      0.5 * (wish.height + std::clamp(height, kLowered * wish.height, kRaised * wish.height));
  return wish;
}

bool FrontRules::clearAround(const Edge& e, const FrontPoint& apex) const {
  const double g =
      std::min(apex.length, kLongerThanBase * (apex.point - vertices_[e.from].point).norm());
  const double vertexLimit = kClearOfVertex * kClearOfVertex * g * g;
  const double edgeLimit = kClearOfEdge * kClearOfEdge * g * g;
  const double sideLimit = kEdgeClearOfVertex * kEdgeClearOfVertex * g * g;
  for (const Near& near : near_) {
    if (near.vertex == e.from || near.vertex == e.to) continue;
    const Vector3d& p = vertices_[near.vertex].point;
    if ((p - apex.point).squaredNorm() < vertexLimit) return false;
    if (squaredDistance(p, vertices_[e.from].point, apex.point) < sideLimit) return false;
    if (squaredDistance(p, vertices_[e.to].point, apex.point) < sideLimit) return false;
  }
  for (const NearEdge& near : nearEdges_) {
    const Edge& other = edges_[near.edge];
    if (other.from == e.from && other.to == e.to) continue;
    if (squaredDistance(apex.point, vertices_[other.from].point, vertices_[other.to].point) <
        edgeLimit)
      return false;
  }
  return true;
}

// Whether a vertex, of a front or finished, lies so near on the same sheet that the surface there
// must be meshed already.
bool FrontRules::meshedAt(const FrontPoint& place) const {
  const double radius = kClearOfMesh * place.length;
  const double shortest =
      place.length * std::max(kClosest * (1.0 - surface_.slope()), kFinestShare);
  bool meshed = false;
  all_.forEachNear(place.point, radius, shortest, [&](std::uint32_t id) {
    meshed = meshed || vertices_[id].normal.dot(place.normal) > kSheet.agreement;
  });
  return meshed;
}

// Whether the sides from the base to the apex cross an edge of the front that shares no end with
// them, or a vertex of the front lies in the triangle.
bool FrontRules::crossesFront(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                              const Vector2d& at) const {
  const Edge& e = edges_[id];
  const Vector2d a = frame.flat(vertices_[e.from].point), b = frame.flat(vertices_[e.to].point);
  for (const Near& near : near_) {
    if (near.vertex == e.from || near.vertex == e.to || near.vertex == apex) continue;
    if (orient2d(a, b, near.at) >= 0 && orient2d(b, at, near.at) >= 0 &&
        orient2d(at, a, near.at) >= 0)
      return true;
  }
  for (const NearEdge& near : nearEdges_) {
    if (near.edge == id) continue;
    const Edge& other = edges_[near.edge];
    if (other.from == apex || other.to == apex) continue;
    if (other.from != e.from && other.to != e.from && cross(a, at, near.from, near.to)) return true;
    if (other.from != e.to && other.to != e.to && cross(b, at, near.from, near.to)) return true;
  }
  return false;
}

bool FrontRules::legal(const Frame& frame, std::uint32_t id, std::uint32_t apex, const Vector2d& at,
                       bool relaxed) const {
  const Edge& e = edges_[id];
  const Vector2d a = frame.flat(vertices_[e.from].point), b = frame.flat(vertices_[e.to].point);
  if (orient2d(a, b, at) <= 0) return false;
  const std::uint32_t before = edges_[e.previous].from, after = edges_[e.next].to;
  if (before != apex && before != e.to) {
    const Vector2d x = frame.flat(vertices_[before].point);
    if (orient2d(a, b, x) > 0 && orient2d(a, at, x) <= 0) return false;
  }
  if (after != apex && after != e.from) {
    const Vector2d y = frame.flat(vertices_[after].point);
    if (orient2d(a, b, y) > 0 && orient2d(at, b, y) <= 0) return false;
  }
  if (apex != none) {
    const Vector3d normal = (vertices_[e.to].point - vertices_[e.from].point)
                                .cross(vertices_[apex].point - vertices_[e.from].point)
                                .normalized();
    const double limit = relaxed ? kRelaxedTriangleAgreement : kTriangleAgreement;
    for (const std::uint32_t v : {e.from, e.to, apex})
      if (normal.dot(vertices_[v].normal) < limit) return false;
  }
  return !crossesFront(frame, id, apex, at);
}

// The triangle may use the sides (to, apex) and (apex, from) when nothing lies there yet, and when
// an edge between these vertices is the neighbouring one of the front.
bool FrontRules::edgesUsable(std::uint32_t id, std::uint32_t apex) const {
  const Edge& e = edges_[id];
  if (used_.has(e.to, apex) || used_.has(apex, e.from)) return false;
  if (used_.has(apex, e.to) && edges_[e.next].to != apex) return false;
  return !used_.has(e.from, apex) || edges_[e.previous].from == apex;
}

// The front edge that leaves the apex where the triangle comes in between it and the edge before.
std::uint32_t FrontRules::openCorner(const Frame& frame, std::uint32_t id, std::uint32_t apex,
                                     const Vector2d& at) const {
  const Edge& e = edges_[id];
  const Vector2d a = frame.flat(vertices_[e.from].point), b = frame.flat(vertices_[e.to].point);
  for (std::uint32_t h = leaving_[apex]; h != none; h = edges_[h].nextLeaving) {
    const std::uint32_t in = edges_[h].previous;
    const Vector2d z = frame.flat(vertices_[edges_[h].to].point);
    const Vector2d y = frame.flat(vertices_[edges_[in].from].point);
    const bool aFits = h == e.previous || inSector(at, z, y, a);
    const bool bFits = in == e.next || inSector(at, z, y, b);
    if (aFits && bFits) return h;
  }
  return none;
}

}  // namespace angiomesh

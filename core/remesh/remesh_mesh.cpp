// SPDX-License-Identifier: BSD-3-Clause
#include "core/remesh/remesh_mesh.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {
namespace {

// The lowest 21 bits of x, each followed by two zeros.
std::uint64_t spreadBits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// What `from` holds at `order`.
template <class T>
std::vector<T> picked(const std::vector<T>& from, const std::vector<std::uint32_t>& order) {
  std::vector<T> to;
  to.reserve(order.size());
  for (const std::uint32_t i : order) to.push_back(from[i]);
  return to;
}

std::vector<std::uint32_t> numbersOf(const std::vector<std::uint32_t>& order, std::size_t slots) {
  std::vector<std::uint32_t> number(slots, EditMesh::none);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  return number;
}

// The numbers whose key is not none, by key (Morton 1966), ties by number.
std::vector<std::uint32_t> sortedBy(const std::vector<std::uint64_t>& keys, std::uint64_t skip) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> list;
  for (std::uint32_t i = 0; i < keys.size(); ++i)
    if (keys[i] != skip) list.emplace_back(keys[i], i);
  std::sort(list.begin(), list.end());
  std::vector<std::uint32_t> order;
  order.reserve(list.size());
  for (const auto& item : list) order.push_back(item.second);
  return order;
}

}  // namespace

EditMesh::EditMesh(const PatchMesh& start)
    : points_(start.mesh.points),
      normals_(start.mesh.points.size(), Vector3d::Zero()),
      sizes_(start.mesh.points.size(), 0.0),
      places_(start.place),
      patches_(start.patch),
      locked_(start.mesh.points.size(), 0),
      origins_(start.origin),
      groups_(start.group) {
  checkMesh(start.mesh);
  const std::size_t count = start.mesh.triangles.size();
  if (places_.size() != points_.size() || patches_.size() != count || origins_.size() != count ||
      (!groups_.empty() && groups_.size() != count))
    throw InputError("the patches of the surface do not fit its triangles", "surface",
                     "make the surface anew");
  corner_.resize(3 * count);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) corner_[3 * t + k] = start.mesh.triangles[t][k];
  leaving_.assign(points_.size(), none);
  valence_.assign(points_.size(), 0);
  buildTwins();
  lockIrregular();
}

// Neighbours are found through lists of the half-edges that leave each vertex.
void EditMesh::buildTwins() {
  const auto n = halfEdgeSlots();
  twin_.assign(n, none);
  std::vector<std::uint32_t> first(points_.size() + 1, 0), list(n);
  for (std::uint32_t h = 0; h < n; ++h) ++first[corner_[h] + 1];
  for (std::size_t v = 0; v < points_.size(); ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::uint32_t h = 0; h < n; ++h) list[fill[corner_[h]]++] = h;
  const auto same = [&](std::uint32_t from, std::uint32_t to, std::uint32_t& found) {
    int count = 0;
    for (std::uint32_t i = first[from]; i < first[from + 1]; ++i)
      if (target(list[i]) == to) {
        ++count;
        found = list[i];
      }
    return count;
  };
  for (std::uint32_t h = 0; h < n; ++h) {
    const std::uint32_t from = corner_[h], to = target(h);
    std::uint32_t mine = none, other = none;
    const int along = same(from, to, mine), against = same(to, from, other);
    if (from == to || along > 1 || against > 1) {
      locked_[from] = locked_[to] = 1;
    } else if (against == 1) {
      twin_[h] = other;
    }
    leaving_[from] = h;
  }
  std::vector<std::uint32_t> fan(points_.size(), 0);
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (leaving_[v] == none) continue;
    startAtRim(v);
    fan[v] = first[v + 1] - first[v];
    std::uint32_t h = leaving_[v], count = 0;
    do {
      ++count;
      h = twin_[previous(h)];
    } while (h != none && h != leaving_[v] && count <= fan[v]);
    if (count != fan[v] || count + 1 >= ringLimit) locked_[v] = 1;
    valence_[v] = h == none ? count + 1 : count;
  }
}

// Turns clockwise to the first half-edge of an open fan.
void EditMesh::startAtRim(std::uint32_t v) {
  const std::uint32_t start = leaving_[v];
  std::uint32_t h = start;
  for (std::size_t n = 0; n < halfEdgeSlots(); ++n) {
    const std::uint32_t o = twin_[h];
    if (o == none) break;
    h = next(o);
    if (h == start) return;
  }
  if (h != start) setLeaving(v, h);
}

// What touches an irregular vertex keeps its corners.
void EditMesh::lockIrregular() {
  const std::vector<std::uint8_t> irregular = locked_;
  for (std::uint32_t h = 0; h < halfEdgeSlots(); ++h)
    if (irregular[corner_[h]] != 0) locked_[target(h)] = locked_[apex(h)] = 1;
}

PatchMesh EditMesh::result() const {
  PatchMesh out;
  std::vector<std::uint32_t> number(points_.size(), none);
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (leaving_[v] == none) continue;
    number[v] = static_cast<std::uint32_t>(out.mesh.points.size());
    out.mesh.points.push_back(points_[v]);
    out.place.push_back(places_[v]);
  }
  for (std::uint32_t t = 0; 3 * t < corner_.size(); ++t) {
    if (!lives(t)) continue;
    out.mesh.triangles.push_back(
        {number[corner_[3 * t]], number[corner_[3 * t + 1]], number[corner_[3 * t + 2]]});
    out.patch.push_back(patches_[t]);
    out.origin.push_back(origins_[t]);
    if (!groups_.empty()) out.group.push_back(groups_[t]);
  }
  return out;
}

void EditMesh::set(std::uint32_t v, const Vector3d& point, const Vector3d& normal, double size) {
  if (trial_) moved_.push_back({v, points_[v], normals_[v], sizes_[v]});
  points_[v] = point;
  normals_[v] = normal;
  sizes_[v] = size;
}

EditMesh::Ring EditMesh::ring(std::uint32_t v) const {
  Ring r;
  std::uint32_t h = leaving_[v];
  const std::uint32_t first = h;
  do {
    const std::uint32_t in = previous(h);
    r.vertex[r.count] = target(h);
    r.side[r.count++] = next(h);
    h = twin_[in];
    if (h == none) {
      r.open = true;
      if (r.count < ringLimit) {
        r.vertex[r.count] = origin(in);
        r.side[r.count++] = none;
      }
    }
  } while (h != none && h != first && r.count < ringLimit);
  return r;
}

std::uint32_t EditMesh::edgeBetween(std::uint32_t u, std::uint32_t v) const {
  std::uint32_t h = leaving_[u];
  const std::uint32_t first = h;
  std::size_t guard = 0;
  do {
    if (target(h) == v) return h;
    const std::uint32_t in = previous(h);
    if (origin(in) == v) return in;
    h = twin_[in];
  } while (h != none && h != first && ++guard < ringLimit);
  return none;
}

bool EditMesh::canFlip(std::uint32_t h) const {
  if (isFeature(h)) return false;
  const std::uint32_t u = origin(h), v = target(h), a = apex(h), b = apex(twin_[h]);
  if (locked(u) || locked(v) || locked(a) || locked(b) || a == b) return false;
  const auto least = [&](std::uint32_t w) { return onRim(w) ? 3U : 4U; };
  if (valence(u) < least(u) || valence(v) < least(v)) return false;
  if (valence(a) + 2 >= ringLimit || valence(b) + 2 >= ringLimit) return false;
  return edgeBetween(a, b) == none;
}

void EditMesh::flip(std::uint32_t h) {
  const std::uint32_t o = twin_[h];
  const std::uint32_t hn = next(h), hp = previous(h), on = next(o), op = previous(o);
  const std::uint32_t u = origin(h), v = target(h), a = origin(hp), b = origin(op);
  const std::uint32_t va = twin_[hn], ub = twin_[on];
  // (u, v, a), (v, u, b) -> (u, b, a), (v, a, b)
  setCorner(hn, b);
  setCorner(on, a);
  join(h, ub);
  join(o, va);
  join(hn, on);
  if (leaving_[u] == on) setLeaving(u, h);
  if (leaving_[v] == hn) setLeaving(v, o);
  constexpr std::uint32_t less = 0xffffffffU;  // minus one
  addValence(u, less);
  addValence(v, less);
  addValence(a, 1);
  addValence(b, 1);
}

std::uint32_t EditMesh::newTriangle(std::uint32_t like) {
  std::uint32_t t = none;
  if (!freeTriangles_.empty()) {
    t = freeTriangles_.back();
    freeTriangles_.pop_back();
    patches_[t] = patches_[like];
    origins_[t] = origins_[like];
    if (!groups_.empty()) groups_[t] = groups_[like];
  } else {
    t = static_cast<std::uint32_t>(patches_.size());
    corner_.resize(corner_.size() + 3, none);
    twin_.resize(twin_.size() + 3, none);
    patches_.push_back(patches_[like]);
    origins_.push_back(origins_[like]);
    if (!groups_.empty()) groups_.push_back(groups_[like]);
  }
  if (trial_) madeTriangles_.push_back(t);
  return t;
}

std::uint32_t EditMesh::newVertex(const Place& place) {
  std::uint32_t v = none;
  if (!freeVertices_.empty()) {
    v = freeVertices_.back();
    freeVertices_.pop_back();
    places_[v] = place;
  } else {
    v = vertexSlots();
    points_.emplace_back(Vector3d::Zero());
    normals_.emplace_back(Vector3d::Zero());
    sizes_.push_back(0.0);
    places_.push_back(place);
    locked_.push_back(0);
    leaving_.push_back(none);
    valence_.push_back(0);
  }
  if (trial_) madeVertices_.push_back(v);
  return v;
}

std::uint32_t EditMesh::split(std::uint32_t h, const Place& place) {
  const std::uint32_t o = twin_[h];
  const std::uint32_t m = newVertex(place);
  // (u, v, a) -> (u, m, a) and (m, v, a)
  const std::uint32_t hn = next(h), a = apex(h), v = target(h), va = twin_[hn];
  const std::uint32_t n = 3 * newTriangle(h / 3);
  setCorner(n, m);
  setCorner(n + 1, v);
  setCorner(n + 2, a);
  setCorner(hn, m);
  join(n + 1, va);
  join(n + 2, hn);
  if (leaving_[v] == hn) setLeaving(v, n + 1);
  setLeaving(m, n);
  put(valence_, 3, m, o == none ? 3 : 4);
  addValence(a, 1);
  if (o == none) {
    setTwin(n, none);
    return m;
  }
  // (v, u, b) -> (v, m, b) and (m, u, b)
  const std::uint32_t on = next(o), b = apex(o), u = target(o), ub = twin_[on];
  const std::uint32_t w = 3 * newTriangle(o / 3);
  setCorner(w, m);
  setCorner(w + 1, u);
  setCorner(w + 2, b);
  setCorner(on, m);
  join(w + 1, ub);
  join(w + 2, on);
  if (leaving_[u] == on) setLeaving(u, w + 1);
  addValence(b, 1);
  join(n, o);
  join(w, h);
  return m;
}

bool EditMesh::canCollapse(std::uint32_t h) const {
  const std::uint32_t o = twin_[h], u = origin(h), v = target(h);
  if (locked(u) || locked(v)) return false;
  const bool rimEdge = o == none;
  if (!rimEdge && onRim(u) && onRim(v)) return false;
  if (onRim(u) && !rimEdge) return false;
  // A vertex between patches may only go along their border.
  const Ring ru = ring(u), rv = ring(v);
  if (ru.count + rv.count + 2 >= ringLimit) return false;
  const bool feature = isFeature(h);
  std::uint32_t featuresU = 0, common = 0;
  for (std::uint32_t i = 0; i < ru.count; ++i) {
    if (locked(ru.vertex[i])) return false;
    for (std::uint32_t j = 0; j < rv.count; ++j) common += ru.vertex[i] == rv.vertex[j] ? 1 : 0;
  }
  std::uint32_t e = leaving_[u];
  for (std::uint32_t i = 0; i < ru.triangles(); ++i) {
    featuresU += isFeature(e) ? 1 : 0;
    if (twin_[previous(e)] == none) ++featuresU;
    e = twin_[previous(e)];
  }
  if (featuresU > 0 && (!feature || featuresU != 2)) return false;
  const auto least = [&](std::uint32_t w) { return onRim(w) ? 3U : 4U; };
  const std::uint32_t a = apex(h);
  if (valence(a) < least(a)) return false;
  if (rimEdge) return common == 1 && ru.count > 2;
  const std::uint32_t b = apex(o);
  return valence(b) >= least(b) && common == 2;
}

void EditMesh::collapse(std::uint32_t h) {
  const std::uint32_t u = origin(h), v = target(h), o = twin_[h];
  std::array<std::uint32_t, ringLimit> corners{};
  std::uint32_t count = 0;
  for (std::uint32_t e = leaving_[u], first = e; e != none && count < ringLimit;) {
    corners[count++] = e;
    e = twin_[previous(e)];
    if (e == first) break;
  }
  for (std::uint32_t i = 0; i < count; ++i) setCorner(corners[i], v);
  const auto drop = [&](std::uint32_t e) {
    // The triangle of e folds up: its other two sides become one.
    const std::uint32_t x = twin_[next(e)], y = twin_[previous(e)], a = apex(e);
    join(x, y);
    setLeaving(a, x != none ? x : next(y));
    // v may have started in this triangle.
    setLeaving(v, y != none ? y : next(x));
    for (std::uint32_t k = 0; k < 3; ++k) setCorner(3 * (e / 3) + k, none);
    (trial_ ? deadTriangles_ : freeTriangles_).push_back(e / 3);
    addValence(a, 0xffffffffU);  // minus one
    return a;
  };
  put(valence_, 3, v, valence_[u] + valence_[v] - (o != none ? 4 : 3));
  const std::uint32_t a = drop(h);
  const std::uint32_t b = o != none ? drop(o) : none;
  setLeaving(u, none);
  (trial_ ? deadVertices_ : freeVertices_).push_back(u);
  startAtRim(v);
  startAtRim(a);
  if (b != none) startAtRim(b);
}

void EditMesh::beginTrial() { trial_ = true; }

void EditMesh::takeBack() {
  for (auto c = changes_.rbegin(); c != changes_.rend(); ++c)
    (c->what == 0   ? corner_
     : c->what == 1 ? twin_
     : c->what == 2 ? leaving_
                    : valence_)[c->index] = c->value;
  for (auto m = moved_.rbegin(); m != moved_.rend(); ++m) {
    points_[m->vertex] = m->point;
    normals_[m->vertex] = m->normal;
    sizes_[m->vertex] = m->size;
  }
  freeTriangles_.insert(freeTriangles_.end(), madeTriangles_.rbegin(), madeTriangles_.rend());
  freeVertices_.insert(freeVertices_.end(), madeVertices_.rbegin(), madeVertices_.rend());
  deadTriangles_.clear();
  deadVertices_.clear();
  keep();
}

void EditMesh::keep() {
  freeTriangles_.insert(freeTriangles_.end(), deadTriangles_.begin(), deadTriangles_.end());
  freeVertices_.insert(freeVertices_.end(), deadVertices_.begin(), deadVertices_.end());
  for (auto* list : {&madeTriangles_, &madeVertices_, &deadTriangles_, &deadVertices_})
    list->clear();
  changes_.clear();
  moved_.clear();
  trial_ = false;
}

void EditMesh::reorder() {
  constexpr std::uint64_t skip = ~std::uint64_t{0};
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (std::uint32_t v = 0; v < vertexSlots(); ++v) {
    if (!livesVertex(v)) continue;
    low = low.cwiseMin(points_[v]);
    high = high.cwiseMax(points_[v]);
  }
  const double extent = (high - low).maxCoeff();
  if (!(extent > 0.0)) return;
  std::vector<std::uint64_t> keys(vertexSlots(), skip);
  for (std::uint32_t v = 0; v < vertexSlots(); ++v) {
    if (!livesVertex(v)) continue;
    const Vector3d p = (points_[v] - low) * (2097151.0 / extent);
    keys[v] = spreadBits(static_cast<std::uint64_t>(p[0])) |
              spreadBits(static_cast<std::uint64_t>(p[1])) << 1 |
              spreadBits(static_cast<std::uint64_t>(p[2])) << 2;
  }
  const std::vector<std::uint32_t> vertices = sortedBy(keys, skip);
  const std::vector<std::uint32_t> vertexNumber = numbersOf(vertices, vertexSlots());
  keys.assign(patches_.size(), skip);
  for (std::uint32_t t = 0; t < patches_.size(); ++t)
    if (lives(t))
      keys[t] = std::min({vertexNumber[corner_[3 * t]], vertexNumber[corner_[3 * t + 1]],
                          vertexNumber[corner_[3 * t + 2]]});
  const std::vector<std::uint32_t> triangles = sortedBy(keys, skip);
  const std::vector<std::uint32_t> triangleNumber = numbersOf(triangles, patches_.size());
  const auto side = [&](std::uint32_t h) {
    return h == none ? none : 3 * triangleNumber[h / 3] + h % 3;
  };
  std::vector<std::uint32_t> corner(3 * triangles.size()), twin(corner.size());
  for (std::uint32_t h = 0; h < corner.size(); ++h) {
    const std::uint32_t old = 3 * triangles[h / 3] + h % 3;
    corner[h] = vertexNumber[corner_[old]];
    twin[h] = side(twin_[old]);
  }
  corner_.swap(corner);
  twin_.swap(twin);
  leaving_ = picked(leaving_, vertices);
  for (std::uint32_t& h : leaving_) h = side(h);
  valence_ = picked(valence_, vertices);
  points_ = picked(points_, vertices);
  normals_ = picked(normals_, vertices);
  sizes_ = picked(sizes_, vertices);
  places_ = picked(places_, vertices);
  locked_ = picked(locked_, vertices);
  patches_ = picked(patches_, triangles);
  origins_ = picked(origins_, triangles);
  if (!groups_.empty()) groups_ = picked(groups_, triangles);
  freeTriangles_.clear();
  freeVertices_.clear();
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/half_edges.h"

namespace angiomesh {

HalfEdges::HalfEdges(const TriMesh& mesh, const std::vector<EdgeSide>& sides)
    : triangles_(mesh.triangles),
      twin_(3 * mesh.triangles.size(), none),
      leaving_(mesh.points.size(), none),
      irregular_(mesh.points.size(), 0) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    const std::size_t count = end - i;
    if (count == 1) continue;
    if (count > 2 || sides[i].forward == sides[i + 1].forward) {
      irregular_[sides[i].low] = irregular_[sides[i].high] = 1;
      continue;
    }
    const std::uint32_t a = 3 * sides[i].triangle + sides[i].side;
    const std::uint32_t b = 3 * sides[i + 1].triangle + sides[i + 1].side;
    twin_[a] = b;
    twin_[b] = a;
  }

  std::vector<std::uint32_t> corners(mesh.points.size(), 0);
  for (std::uint32_t h = 0; h < twin_.size(); ++h) {
    const auto& t = triangles_[h / 3];
    const std::uint32_t v = origin(h);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      irregular_[v] = 1;
      continue;
    }
    ++corners[v];
    if (leaving_[v] == none || twin_[h] == none) leaving_[v] = h;
  }
  for (std::uint32_t v = 0; v < leaving_.size(); ++v) {
    if (leaving_[v] == none) continue;
    std::uint32_t visited = 0;
    std::uint32_t h = leaving_[v];
    do {
      ++visited;
      h = twin_[previous(h)];
    } while (h != none && h != leaving_[v]);
    if (visited != corners[v]) irregular_[v] = 1;
  }
}

int HalfEdges::valence(std::uint32_t v) const {
  int count = 0;
  forEachNeighbour(v, [&](std::uint32_t) { ++count; });
  return count;
}

bool HalfEdges::canFlip(std::uint32_t h) const {
  const std::uint32_t t = twin_[h];
  if (t == none) return false;
  const std::uint32_t a = origin(h), b = origin(t);
  const std::uint32_t c = origin(previous(h)), d = origin(previous(t));
  if (c == d || irregular(a) || irregular(b) || irregular(c) || irregular(d)) return false;
  if (valence(a) <= (onRim(a) ? 2 : 3) || valence(b) <= (onRim(b) ? 2 : 3)) return false;
  bool joined = false;
  forEachNeighbour(c, [&](std::uint32_t v) { joined = joined || v == d; });
  return !joined;
}

void HalfEdges::flip(std::uint32_t h) {
  const std::uint32_t g = twin_[h];
  const std::uint32_t a = origin(h), b = origin(g);
  const std::uint32_t bc = next(h), ca = previous(h), ad = next(g), db = previous(g);
  const std::uint32_t c = origin(ca), d = origin(db);
  const std::uint32_t s = h / 3, t = g / 3;
  const std::uint32_t twins[4] = {twin_[ad], twin_[ca], twin_[db], twin_[bc]};
  const std::uint32_t moved[4] = {3 * s, 3 * s + 2, 3 * t, 3 * t + 1};  // the same edges, after
  const bool leavesByAd = leaving_[a] == ad || leaving_[a] == h;
  const bool leavesByBc = leaving_[b] == bc || leaving_[b] == g;
  const bool leavesByCa = leaving_[c] == ca, leavesByDb = leaving_[d] == db;

  triangles_[s] = {a, d, c};
  triangles_[t] = {d, b, c};
  for (int k = 0; k < 4; ++k) {
    twin_[moved[k]] = twins[k];
    if (twins[k] != none) twin_[twins[k]] = moved[k];
  }
  twin_[3 * s + 1] = 3 * t + 2;
  twin_[3 * t + 2] = 3 * s + 1;
  if (leavesByAd) leaving_[a] = moved[0];
  if (leavesByCa) leaving_[c] = moved[1];
  if (leavesByDb) leaving_[d] = moved[2];
  if (leavesByBc) leaving_[b] = moved[3];
}

}  // namespace angiomesh

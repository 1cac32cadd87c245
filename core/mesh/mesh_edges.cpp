// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_edges.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace angiomesh {
namespace {

// Sides in the order of their triangles stay so where they have the same edge.
void sortByHigh(EdgeSide* first, EdgeSide* last) {
  constexpr std::ptrdiff_t few = 32;
  const auto before = [](const EdgeSide& x, const EdgeSide& y) { return x.high < y.high; };
  if (last - first > few) {
    std::stable_sort(first, last, before);
    return;
  }
  for (EdgeSide* next = first; next != last; ++next) {
    const EdgeSide side = *next;
    EdgeSide* hole = next;
    for (; hole != first && before(side, hole[-1]); --hole) *hole = hole[-1];
    *hole = side;
  }
}

}  // namespace

std::vector<EdgeSide> sortedEdgeSides(const TriMesh& mesh) {
  // Bucketing by the lower vertex leaves a handful of sides to sort in each bucket.
  const std::size_t vertices = mesh.points.size();
  std::vector<std::uint32_t> first(vertices + 1, 0);
  for (const auto& t : mesh.triangles) {
    if (repeatsVertex(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) ++first[std::min(t[k], t[(k + 1) % 3]) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<EdgeSide> sides(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    if (repeatsVertex(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides[next[std::min(a, b)]++] = {std::min(a, b), std::max(a, b),
                                       static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(k),
                                       a < b};
    }
  }
  for (std::size_t v = 0; v < vertices; ++v)
    sortByHigh(sides.data() + first[v], sides.data() + first[v + 1]);
  return sides;
}

std::size_t edgeRunEnd(const std::vector<EdgeSide>& sides, std::size_t first) {
  std::size_t last = first + 1;
  while (last < sides.size() && sides[last].low == sides[first].low &&
         sides[last].high == sides[first].high) {
    ++last;
  }
  return last;
}

VertexFans vertexFans(const TriMesh& mesh, const std::vector<EdgeSide>& sides) {
  VertexFans fans{DisjointSets(3 * mesh.triangles.size()),
                  std::vector<char>(mesh.points.size(), 0)};
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    for (const std::uint32_t v : {sides[i].low, sides[i].high}) {
      if (end - i > 2) fans.several[v] = 1;
      for (std::size_t j = i + 1; j < end; ++j)
        fans.ofCorners.join(cornerAt(mesh, sides[i].triangle, v),
                            cornerAt(mesh, sides[j].triangle, v));
    }
  }
  constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::uint32_t> fanOf(mesh.points.size(), none);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const auto& t = mesh.triangles[corner / 3];
    if (repeatsVertex(t)) continue;
    const std::uint32_t v = t[corner % 3], fan = fans.ofCorners.find(corner);
    if (fanOf[v] != none && fanOf[v] != fan) fans.several[v] = 1;
    fanOf[v] = fan;
  }
  return fans;
}

std::vector<char> irregularVertices(const TriMesh& mesh, const std::vector<EdgeSide>& sides) {
  std::vector<char> irregular = vertexFans(mesh, sides).several;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high &&
        sides[i].forward == sides[i - 1].forward)
      irregular[sides[i].low] = irregular[sides[i].high] = 1;
  for (const auto& t : mesh.triangles)
    if (repeatsVertex(t))
      for (const std::uint32_t v : t) irregular[v] = 1;
  return irregular;
}

std::vector<RimEdge> rimEdges(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  const auto patchOf = [&](const EdgeSide& s) {
    return mesh.patch.empty() ? std::uint16_t{0} : mesh.patch[s.triangle];
  };
  std::vector<RimEdge> rims;
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    const std::size_t count = edgeRunEnd(sides, i) - i;
    const std::uint16_t pa = patchOf(sides[i]);
    const std::uint16_t pb = count == 2 ? patchOf(sides[i + 1]) : pa;
    if (count > 2 || (count == 2 && pa == pb)) continue;
    // What is to the left of an edge of the wall lies to the right of the opening's.
    const bool forward = count == 1 ? !sides[i].forward : sides[pa > pb ? i : i + 1].forward;
    const std::uint32_t low = sides[i].low, high = sides[i].high;
    rims.push_back({forward ? low : high, forward ? high : low, count == 1, std::min(pa, pb),
                    std::max(pa, pb)});
  }
  return rims;
}

std::vector<std::vector<std::uint32_t>> closedLoops(std::map<std::uint32_t, std::uint32_t> next) {
  std::vector<std::vector<std::uint32_t>> loops;
  while (!next.empty()) {
    std::vector<std::uint32_t> loop;
    const std::uint32_t start = next.begin()->first;
    std::uint32_t v = start;
    for (auto at = next.find(v); at != next.end(); at = next.find(v)) {
      loop.push_back(v);
      v = at->second;
      next.erase(at);
    }
    if (v == start && loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

MeshComponents meshComponents(const TriMesh& mesh) {
  return meshComponents(mesh, sortedEdgeSides(mesh));
}

MeshComponents meshComponents(const TriMesh& mesh, const std::vector<EdgeSide>& sides) {
  DisjointSets sets(mesh.triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high) {
      sets.join(sides[i].triangle, sides[i - 1].triangle);
    }
  }
  MeshComponents result;
  result.label.resize(mesh.triangles.size());
  for (std::uint32_t i = 0; i < result.label.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    result.label[i] = root == i ? static_cast<std::uint32_t>(result.count++) : result.label[root];
  }
  return result;
}

}  // namespace angiomesh

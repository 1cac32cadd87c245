// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// Adjacency of a triangle list that edges can be flipped in. Half-edge 3 t + k runs from corner k
/// of triangle t to the next one. Vertices whose triangles are not one fan, or disagree in
/// orientation, are `irregular`: only one of their fans can be visited.
class HalfEdges {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  explicit HalfEdges(const TriMesh& mesh) : HalfEdges(mesh, sortedEdgeSides(mesh)) {}
  /// With the mesh's sortedEdgeSides().
  HalfEdges(const TriMesh& mesh, const std::vector<EdgeSide>& sides);

  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& triangles() const {
    return triangles_;
  }
  [[nodiscard]] std::uint32_t origin(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
  [[nodiscard]] std::uint32_t target(std::uint32_t h) const { return origin(next(h)); }
  [[nodiscard]] static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static std::uint32_t previous(std::uint32_t h) {
    return h % 3 == 0 ? h + 2 : h - 1;
  }
  /// The same edge in the neighbouring triangle; none on a rim.
  [[nodiscard]] std::uint32_t twin(std::uint32_t h) const { return twin_[h]; }

  [[nodiscard]] bool irregular(std::uint32_t v) const { return irregular_[v] != 0; }
  [[nodiscard]] bool onRim(std::uint32_t v) const {
    return leaving_[v] != none && twin_[leaving_[v]] == none;
  }
  [[nodiscard]] int valence(std::uint32_t v) const;

  /// Calls visit(neighbour) for each vertex joined to v by an edge, counter-clockwise; at a rim
  /// the first and the last one are its neighbours along the rim.
  template <class Visit>
  void forEachNeighbour(std::uint32_t v, Visit visit) const {
    std::uint32_t h = leaving_[v];
    if (h == none) return;
    const std::uint32_t first = h;
    do {
      visit(target(h));
      const std::uint32_t in = previous(h);
      h = twin_[in];
      if (h == none) visit(origin(in));
    } while (h != none && h != first);
  }

  /// Whether the edge of h can be flipped and leave a manifold: inner edge, regular vertices of
  /// valence above 3 (rim: 2) at its ends, and no edge yet between the opposite corners.
  [[nodiscard]] bool canFlip(std::uint32_t h) const;

  /// Replaces the edge by the one between the opposite corners; canFlip() must hold.
  void flip(std::uint32_t h);

 private:
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint32_t> leaving_;  ///< a half-edge from each vertex; at a rim the first one
  std::vector<char> irregular_;
};

}  // namespace angiomesh

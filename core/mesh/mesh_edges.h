// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/mesh/tri_mesh.h"

namespace angiomesh {

/// One side of a triangle: corner `side` of triangle `triangle` and the next corner.
struct EdgeSide {
  std::uint32_t low = 0, high = 0;  ///< the two vertices, low < high
  std::uint32_t triangle = 0;
  std::uint8_t side = 0;
  bool forward = false;  ///< the triangle runs from low to high
};

/// The sides of all triangles sorted by edge (then by triangle), so that the sides of one edge are
/// neighbours. Sides whose triangle repeats a vertex are left out: such a triangle joins nothing.
std::vector<EdgeSide> sortedEdgeSides(const TriMesh& mesh);

/// The end of the run of equal edges that starts at `first`.
std::size_t edgeRunEnd(const std::vector<EdgeSide>& sides, std::size_t first);

/// Corner k of triangle t is 3 t + k.
inline std::uint32_t cornerAt(const TriMesh& mesh, std::uint32_t triangle, std::uint32_t vertex) {
  const auto& t = mesh.triangles[triangle];
  return 3 * triangle + (t[0] == vertex ? 0U : t[1] == vertex ? 1U : 2U);
}

/// A fan is a set of corners at one vertex whose triangles hang together by edges; a vertex of a
/// manifold has one. Triangles that repeat a vertex count for nothing.
struct VertexFans {
  DisjointSets ofCorners;
  std::vector<char> several;  ///< per vertex: 1 with several fans, or an edge of several triangles
};
/// `sides` are the mesh's sortedEdgeSides().
VertexFans vertexFans(const TriMesh& mesh, const std::vector<EdgeSide>& sides);

/// Per vertex: 1 where its triangles are not one fan, disagree in orientation, or repeat it.
std::vector<char> irregularVertices(const TriMesh& mesh, const std::vector<EdgeSide>& sides);

/// An edge that a surface ends at: of one triangle alone, or between two patches.
struct RimEdge {
  std::uint32_t from = 0, to = 0;  ///< the opening, or the patch of the higher number, to the left
  bool open = false;
  /// Of its triangles: the lower number and the higher, the same at an open rim.
  std::uint16_t patch = 0, otherPatch = 0;
};
std::vector<RimEdge> rimEdges(const TriMesh& mesh);

/// The closed loops of edges of which at most one leaves each vertex: from -> to. Chains that do
/// not close, and loops of fewer than three edges, are left out.
std::vector<std::vector<std::uint32_t>> closedLoops(std::map<std::uint32_t, std::uint32_t> next);

/// The label of each triangle's edge-connected component, 0..count-1 by first triangle.
struct MeshComponents {
  std::vector<std::uint32_t> label;
  std::size_t count = 0;
};
MeshComponents meshComponents(const TriMesh& mesh);
/// With the mesh's sortedEdgeSides().
MeshComponents meshComponents(const TriMesh& mesh, const std::vector<EdgeSide>& sides);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/smoothing.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <optional>

#include "core/base/parallel.h"
#include "core/mesh/mesh_edges.h"
#include "core/openings/held_planes.h"
#include "core/smooth/smooth_soundly.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 4096;

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

// None where the mesh is no manifold: vertices of several fans and edges of several triangles have
// no place in OpenMesh.
std::optional<HalfEdgeMesh> halfEdgeMesh(const TriMesh& mesh) {
  for (const char irregular : irregularVertices(mesh, sortedEdgeSides(mesh)))
    if (irregular != 0) return std::nullopt;
  HalfEdgeMesh result;
  result.reserve(mesh.points.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
  for (const Eigen::Vector3d& p : mesh.points) result.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& t : mesh.triangles) {
    const auto vertex = [&](std::size_t k) {
      return HalfEdgeMesh::VertexHandle(static_cast<int>(t[k]));
    };
    if (!result.add_face(vertex(0), vertex(1), vertex(2)).is_valid()) return std::nullopt;
  }
  return result;
}

std::uint32_t patchOf(const TriMesh& mesh, std::size_t triangle) {
  return mesh.patch.empty() ? 0U : static_cast<std::uint32_t>(mesh.patch[triangle]);
}

// The part of a move that leaves a vertex in its planes.
Eigen::Vector3d heldMove(const HeldPlanes& held, std::uint32_t v, const Eigen::Vector3d& move) {
  if (held.count(v) == 0) return move;
  if (held.count(v) > 1) return Eigen::Vector3d::Zero();
  return move - move.dot(held.normal(v)) * held.normal(v);
}

// One step on OpenMesh, whose faces are numbered as the triangles: vertices of a rim average over
// their neighbours along it.
void step(HalfEdgeMesh& mesh, const TriMesh& start, const HeldPlanes& held, double factor,
          std::vector<OpenMesh::Vec3d>& moved, const Progress& progress) {
  const auto isRim = [&](HalfEdgeMesh::HalfedgeHandle h) {
    if (mesh.is_boundary(mesh.edge_handle(h))) return true;
    const auto face = [&](HalfEdgeMesh::HalfedgeHandle side) {
      return patchOf(start, static_cast<std::size_t>(mesh.face_handle(side).idx()));
    };
    return face(h) != face(mesh.opposite_halfedge_handle(h));
  };
  parallelForEach(moved.size(), blockSize, progress, [&](std::size_t i) {
    const HalfEdgeMesh::VertexHandle v(static_cast<int>(i));
    const OpenMesh::Vec3d& p = mesh.point(v);
    moved[i] = p;
    if (mesh.is_isolated(v)) return;
    OpenMesh::Vec3d sum(0.0, 0.0, 0.0);
    int count = 0;
    bool rim = false;
    for (auto h = mesh.cvoh_ccwbegin(v); h.is_valid(); ++h) rim = rim || isRim(*h);
    for (auto h = mesh.cvoh_ccwbegin(v); h.is_valid(); ++h) {
      if (rim && !isRim(*h)) continue;
      sum += mesh.point(mesh.to_vertex_handle(*h));
      ++count;
    }
    const OpenMesh::Vec3d move = factor * (sum / count - p);
    const Eigen::Vector3d allowed =
        heldMove(held, static_cast<std::uint32_t>(i), {move[0], move[1], move[2]});
    moved[i] += OpenMesh::Vec3d(allowed.x(), allowed.y(), allowed.z());
  });
  for (std::size_t i = 0; i < moved.size(); ++i)
    mesh.set_point(HalfEdgeMesh::VertexHandle(static_cast<int>(i)), moved[i]);
}

// The vertices that each vertex of a mesh that is no manifold averages over: on a rim those along
// the rim.
struct Neighbours {
  std::vector<std::uint32_t> first;  ///< of vertex v: list[first[v]] to list[first[v + 1] - 1]
  std::vector<std::uint32_t> list;
};

Neighbours averagingNeighbours(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  struct Edge {
    std::uint32_t low, high;
    bool rim;
  };
  std::vector<Edge> edges;
  std::vector<char> onRim(mesh.points.size(), 0);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    const std::size_t count = edgeRunEnd(sides, i) - i;
    const bool rim = count == 1 || (count == 2 && patchOf(mesh, sides[i].triangle) !=
                                                      patchOf(mesh, sides[i + 1].triangle));
    edges.push_back({sides[i].low, sides[i].high, rim});
    if (edges.back().rim) onRim[sides[i].low] = onRim[sides[i].high] = 1;
  }
  Neighbours result;
  result.first.assign(mesh.points.size() + 1, 0);
  const auto forEach = [&](auto visit) {
    for (const Edge& e : edges) {
      if (e.rim || onRim[e.low] == 0) visit(e.low, e.high);
      if (e.rim || onRim[e.high] == 0) visit(e.high, e.low);
    }
  };
  forEach([&](std::uint32_t v, std::uint32_t) { ++result.first[v + 1]; });
  for (std::size_t v = 0; v < mesh.points.size(); ++v) result.first[v + 1] += result.first[v];
  result.list.resize(result.first.back());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  forEach([&](std::uint32_t v, std::uint32_t n) { result.list[next[v]++] = n; });
  return result;
}

void step(const Neighbours& neighbours, const HeldPlanes& held, double factor,
          std::vector<Eigen::Vector3d>& points, std::vector<Eigen::Vector3d>& moved,
          const Progress& progress) {
  parallelForEach(moved.size(), blockSize, progress, [&](std::size_t v) {
    const std::uint32_t first = neighbours.first[v], last = neighbours.first[v + 1];
    moved[v] = points[v];
    if (first == last) return;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t i = first; i < last; ++i) sum += points[neighbours.list[i]];
    moved[v] += heldMove(held, static_cast<std::uint32_t>(v),
                         factor * (sum / static_cast<double>(last - first) - points[v]));
  });
  points.swap(moved);
}

// Calls forward(factor) for each step of the filter.
template <class Step>
void filter(const SmoothParams& params, const Progress& progress, Step forward) {
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    forward(params.lambda);
    forward(params.mu);
    progress.report(static_cast<double>(iteration + 1) / params.iterations);
  }
}

}  // namespace

TriMesh taubinSmooth(const TriMesh& mesh, const SmoothParams& params, const Progress& progress,
                     const std::vector<Port>& ports) {
  progress.report(0.0);
  checkMesh(mesh);
  TriMesh result = mesh;
  if (params.iterations > 0) {
    const HeldPlanes held(mesh, nullptr, ports);
    if (auto halfEdges = halfEdgeMesh(mesh)) {
      std::vector<OpenMesh::Vec3d> moved(mesh.points.size());
      filter(params, progress,
             [&](double factor) { step(*halfEdges, mesh, held, factor, moved, progress); });
      for (std::size_t v = 0; v < moved.size(); ++v)
        result.points[v] = {moved[v][0], moved[v][1], moved[v][2]};
    } else {
      const Neighbours neighbours = averagingNeighbours(mesh);
      std::vector<Eigen::Vector3d> moved(mesh.points.size());
      filter(params, progress, [&](double factor) {
        step(neighbours, held, factor, result.points, moved, progress);
      });
    }
  }
  progress.report(1.0);
  return result;
}

TriMesh smoothSurface(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
                      const Progress& progress, const std::vector<Port>& ports, std::size_t* left) {
  if (params.method == SmoothMethod::None) return mesh;
  if (params.method == SmoothMethod::KeepWall)
    return keepWallSmooth(mesh, params, phi, progress, ports, left);
  const TriMesh filtered = taubinSmooth(mesh, params, progress.sub(0.0, 0.8), ports);
  const auto held = [&](const std::vector<char>& frozen) {
    TriMesh result = filtered;
    for (std::size_t v = 0; v < frozen.size(); ++v)
      if (frozen[v] != 0) result.points[v] = mesh.points[v];
    return result;
  };
  std::size_t count = 0;
  TriMesh smoothed = smoothSoundly(mesh, held, count, progress.sub(0.8, 0.95));
  if (left != nullptr) *left += count;
  progress.report(1.0);
  return smoothed;
}

std::string leftUnsmoothed(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " component" : " components") +
         " of the surface stayed unsmoothed: smoothed they would cut themselves or others";
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/smoothing.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <optional>

#include "core/base/parallel.h"
#include "core/surface/half_edges.h"
#include "core/surface/mesh_edges.h"

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
  const HalfEdges edges(mesh);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
    if (edges.irregular(v)) return std::nullopt;
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

// One step on OpenMesh: vertices of a rim average over their neighbours along it.
void step(HalfEdgeMesh& mesh, double factor, std::vector<OpenMesh::Vec3d>& moved,
          const Progress& progress) {
  parallelFor(0, moved.size(), blockSize, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t i = begin; i < end; ++i) {
      const HalfEdgeMesh::VertexHandle v(static_cast<int>(i));
      const OpenMesh::Vec3d& p = mesh.point(v);
      moved[i] = p;
      if (mesh.is_isolated(v)) continue;
      OpenMesh::Vec3d sum(0.0, 0.0, 0.0);
      int count = 0;
      const bool rim = mesh.is_boundary(v);
      for (auto h = mesh.cvoh_ccwbegin(v); h.is_valid(); ++h) {
        if (rim && !mesh.is_boundary(mesh.edge_handle(*h))) continue;
        sum += mesh.point(mesh.to_vertex_handle(*h));
        ++count;
      }
      moved[i] += factor * (sum / count - p);
    }
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
    edges.push_back({sides[i].low, sides[i].high, edgeRunEnd(sides, i) == i + 1});
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

void step(const Neighbours& neighbours, double factor, std::vector<Eigen::Vector3d>& points,
          std::vector<Eigen::Vector3d>& moved, const Progress& progress) {
  parallelFor(0, moved.size(), blockSize, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t v = begin; v < end; ++v) {
      const std::uint32_t first = neighbours.first[v], last = neighbours.first[v + 1];
      moved[v] = points[v];
      if (first == last) continue;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::uint32_t i = first; i < last; ++i) sum += points[neighbours.list[i]];
      moved[v] += factor * (sum / static_cast<double>(last - first) - points[v]);
    }
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

TriMesh taubinSmooth(const TriMesh& mesh, const SmoothParams& params, const Progress& progress) {
  progress.report(0.0);
  checkMesh(mesh);
  TriMesh result = mesh;
  if (params.iterations > 0) {
    if (auto halfEdges = halfEdgeMesh(mesh)) {
      std::vector<OpenMesh::Vec3d> moved(mesh.points.size());
      filter(params, progress, [&](double factor) { step(*halfEdges, factor, moved, progress); });
      for (std::size_t v = 0; v < moved.size(); ++v)
        result.points[v] = {moved[v][0], moved[v][1], moved[v][2]};
    } else {
      const Neighbours neighbours = averagingNeighbours(mesh);
      std::vector<Eigen::Vector3d> moved(mesh.points.size());
      filter(params, progress,
             [&](double factor) { step(neighbours, factor, result.points, moved, progress); });
    }
  }
  progress.report(1.0);
  return result;
}

TriMesh smoothSurface(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
                      const Progress& progress) {
  switch (params.method) {
    case SmoothMethod::KeepWall:
      return keepWallSmooth(mesh, params, phi, progress);
    case SmoothMethod::Taubin:
      return taubinSmooth(mesh, params, progress);
    case SmoothMethod::None:
      break;
  }
  return mesh;
}

}  // namespace angiomesh

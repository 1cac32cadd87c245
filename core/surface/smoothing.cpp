// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/smoothing.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/surface/mesh_edges.h"

namespace angiomesh {
namespace {

// The vertices that each vertex averages over: on a rim those along the rim.
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

}  // namespace

TriMesh taubinSmooth(const TriMesh& mesh, const SmoothParams& params, const Progress& progress) {
  progress.report(0.0);
  checkMesh(mesh);
  const Neighbours neighbours = averagingNeighbours(mesh);
  TriMesh result = mesh;
  std::vector<Eigen::Vector3d> moved(mesh.points.size());
  for (int iteration = 0; iteration < params.iterations; ++iteration) {
    for (const double factor : {params.lambda, params.mu}) {
      parallelFor(0, moved.size(), 4096, [&](std::size_t begin, std::size_t end) {
        progress.check();
        for (std::size_t v = begin; v < end; ++v) {
          const Eigen::Vector3d& p = result.points[v];
          const std::uint32_t first = neighbours.first[v], last = neighbours.first[v + 1];
          moved[v] = p;
          if (first == last) continue;
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (std::uint32_t i = first; i < last; ++i) sum += result.points[neighbours.list[i]];
          moved[v] += factor * (sum / static_cast<double>(last - first) - p);
        }
      });
      result.points.swap(moved);
    }
    progress.report(static_cast<double>(iteration + 1) / params.iterations);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/port_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/surface/flat_area.h"
#include "core/surface/mesh_edges.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr int kBorders = 6;

std::string borderName(std::size_t number) { return "border_" + std::to_string(number); }

Port portOf(const FlatArea& area) { return {"", area.centre(), area.normal(), area.areaMm2()}; }

/// Border caps and rims, the largest first, named.
std::vector<Port> inOrder(std::vector<Port> ports, std::vector<std::size_t>& order) {
  order.resize(ports.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ports[a].areaMm2 > ports[b].areaMm2;
  });
  std::vector<Port> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(ports[i]);
    sorted.back().name = borderName(sorted.size());
  }
  return sorted;
}

/// Numbers the caps in border planes after `first` patches: connected triangles of one plane.
std::vector<Port> borderCaps(PatchMesh& mesh, std::size_t first) {
  DisjointSets sets(mesh.patch.size());
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh.mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    if (edgeRunEnd(sides, i) != i + 2) continue;
    const std::uint32_t a = sides[i].triangle, b = sides[i + 1].triangle;
    if (mesh.patch[a] == mesh.patch[b]) sets.join(a, b);
  }
  std::map<std::uint32_t, std::uint16_t> numberOf;
  std::vector<std::uint16_t> number(mesh.patch.size(), 0);
  for (std::uint32_t t = 0; t < number.size(); ++t) {
    if (mesh.patch[t] == 0 || mesh.patch[t] > kBorders) continue;
    const auto next = static_cast<std::uint16_t>(numberOf.size() + 1);
    number[t] = numberOf.try_emplace(sets.find(t), next).first->second;
  }
  TriMesh caps{mesh.mesh.points, mesh.mesh.triangles, number};
  std::vector<std::size_t> order;
  std::vector<Port> ports = inOrder(measurePatches(caps, numberOf.size()), order);
  std::vector<std::uint16_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = static_cast<std::uint16_t>(first + i + 1);
  for (std::size_t t = 0; t < number.size(); ++t)
    if (number[t] != 0) mesh.mesh.patch[t] = rank[number[t] - 1U];
  return ports;
}

struct Rims {
  std::map<int, FlatArea> cuts;  ///< per plane
  std::vector<Port> borders;
};

Rims measureRims(const PatchMesh& mesh, const EndPlanes& ends) {
  Rims rims;
  DisjointSets sets(mesh.mesh.points.size());
  struct Edge {
    std::uint32_t from, to;
    int plane;
  };
  std::vector<Edge> edges;
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh.mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    const EdgeSide& s = sides[i];
    if (edgeRunEnd(sides, i) != i + 1) continue;
    const int plane = mesh.place[s.low].shared(mesh.place[s.high]).firstPlane();
    if (plane < 0) continue;
    // A cap's side of the edge runs against the wall's.
    edges.push_back({s.forward ? s.high : s.low, s.forward ? s.low : s.high, plane});
    if (plane < kBorders) sets.join(s.low, s.high);
  }
  std::map<std::pair<std::uint32_t, int>, FlatArea> loops;
  for (const Edge& e : edges) {
    const FlatArea none(ends.normal(e.plane));
    FlatArea& area = e.plane < kBorders
                         ? loops.try_emplace({sets.find(e.from), e.plane}, none).first->second
                         : rims.cuts.try_emplace(e.plane, none).first->second;
    area.add(mesh.mesh.points[e.from], mesh.mesh.points[e.to]);
  }
  for (const auto& [where, area] : loops)
    if (area.areaMm2() > 0.0) rims.borders.push_back(portOf(area));
  return rims;
}

}  // namespace

std::vector<Port> numberPatches(PatchMesh& mesh, const EndPlanes& ends, const CutAway& away) {
  const std::size_t cuts = away.sections.size();
  mesh.mesh.patch.assign(mesh.patch.size(), 0);
  for (std::size_t t = 0; t < mesh.patch.size(); ++t)
    if (mesh.patch[t] > kBorders)
      mesh.mesh.patch[t] = static_cast<std::uint16_t>(mesh.patch[t] - kBorders);
  std::vector<Port> ports = measurePatches(mesh.mesh, cuts);
  std::vector<Port> borders = borderCaps(mesh, cuts);
  const Rims rims = measureRims(mesh, ends);
  for (const auto& [plane, area] : rims.cuts)
    if (area.areaMm2() > 0.0) ports[static_cast<std::size_t>(plane - kBorders)] = portOf(area);
  for (std::size_t n = 0; n < cuts; ++n) {
    ports[n].name = n < away.names.size() && !away.names[n].empty()
                        ? away.names[n]
                        : "cut_" + std::to_string(n + 1);
    if (ports[n].areaMm2 > 0.0) continue;
    ports[n].centreLps = away.sections[n].centreLps;
    ports[n].normalLps = away.sections[n].plane.normalLps;
  }
  if (borders.empty()) {
    std::vector<std::size_t> order;
    borders = inOrder(rims.borders, order);
  }
  ports.insert(ports.end(), borders.begin(), borders.end());
  return ports;
}

void dropLostPorts(TriMesh& mesh, std::vector<Port>& ports, std::size_t cuts) {
  const std::vector<Port> measured = measuredPorts(ports, mesh);
  std::vector<Port> left;
  std::vector<std::uint16_t> number(ports.size() + 1, 0);
  for (std::size_t n = 0; n < ports.size(); ++n) {
    if (n >= cuts && !(measured[n].areaMm2 > 0.0)) continue;
    left.push_back(measured[n]);
    if (n >= cuts) left.back().name = borderName(left.size() - cuts);
    number[n + 1] = static_cast<std::uint16_t>(left.size());
  }
  for (std::uint16_t& patch : mesh.patch) patch = number[patch];
  ports = std::move(left);
}

}  // namespace angiomesh

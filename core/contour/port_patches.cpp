// SPDX-License-Identifier: BSD-3-Clause
#include "core/contour/port_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/mesh/flat_area.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr int kBorders = 6;

std::string borderName(std::size_t number) { return kBorderPrefix + std::to_string(number); }

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
    sorted.back().atBorder = true;
  }
  return sorted;
}

/// Numbers the caps in border planes after the first `cuts` patches: connected triangles of one
/// plane.
std::vector<Port> borderCaps(PatchMesh& mesh, std::size_t cuts) {
  const auto isBorder = [&](std::size_t t) {
    return mesh.patch[t] > 0 && mesh.patch[t] <= kBorders;
  };
  TriMesh caps;
  caps.points.resize(mesh.mesh.points.size());
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < mesh.patch.size(); ++t) {
    if (!isBorder(t)) continue;
    triangles.push_back(t);
    caps.triangles.push_back(mesh.mesh.triangles[t]);
  }
  DisjointSets sets(triangles.size());
  const std::vector<EdgeSide> sides = sortedEdgeSides(caps);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    if (edgeRunEnd(sides, i) != i + 2) continue;
    const std::uint32_t a = sides[i].triangle, b = sides[i + 1].triangle;
    if (mesh.patch[triangles[a]] == mesh.patch[triangles[b]]) sets.join(a, b);
  }
  std::map<std::uint32_t, std::uint16_t> numberOf;
  std::vector<std::uint16_t>& patch = mesh.mesh.patch;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto next = static_cast<std::uint16_t>(cuts + numberOf.size() + 1);
    patch[triangles[i]] = numberOf.try_emplace(sets.find(i), next).first->second;
  }
  std::vector<Port> found = measurePatches(mesh.mesh, cuts + numberOf.size());
  found.erase(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(cuts));
  std::vector<std::size_t> order;
  std::vector<Port> ports = inOrder(std::move(found), order);
  std::vector<std::uint16_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = static_cast<std::uint16_t>(cuts + i + 1);
  for (const std::uint32_t t : triangles) patch[t] = rank[patch[t] - cuts - 1U];
  return ports;
}

struct Rims {
  std::map<int, FlatArea> cuts;  ///< per plane
  std::vector<Port> borders;
};

Rims measureRims(const PatchMesh& mesh, const EndPlanes& ends) {
  Rims rims;
  DisjointSets sets(mesh.mesh.points.size());
  std::vector<std::pair<RimEdge, int>> edges;
  for (const RimEdge& edge : rimEdges(mesh.mesh)) {
    const int plane = mesh.place[edge.from].shared(mesh.place[edge.to]).firstPlane();
    if (!edge.open || plane < 0) continue;
    edges.emplace_back(edge, plane);
    if (plane < kBorders) sets.join(edge.from, edge.to);
  }
  std::map<std::pair<std::uint32_t, int>, FlatArea> loops;
  for (const auto& [edge, plane] : edges) {
    const FlatArea none(ends.normal(plane));
    FlatArea& area = plane < kBorders
                         ? loops.try_emplace({sets.find(edge.from), plane}, none).first->second
                         : rims.cuts.try_emplace(plane, none).first->second;
    area.add(mesh.mesh.points[edge.from], mesh.mesh.points[edge.to]);
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

std::vector<std::size_t> dropLostPorts(TriMesh& mesh, std::vector<Port>& ports, std::size_t cuts) {
  std::vector<std::size_t> lost;
  const std::vector<Port> measured = measuredPorts(ports, mesh);
  std::vector<Port> left;
  std::vector<std::uint16_t> number(ports.size() + 1, 0);
  for (std::size_t n = 0; n < ports.size(); ++n) {
    if (!(measured[n].areaMm2 > 0.0)) {
      if (n < cuts) lost.push_back(n);
      continue;
    }
    left.push_back(measured[n]);
    if (n >= cuts) left.back().name = borderName(left.size() + lost.size() - cuts);
    number[n + 1] = static_cast<std::uint16_t>(left.size());
  }
  for (std::uint16_t& patch : mesh.patch) patch = number[patch];
  ports = std::move(left);
  return lost;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth/smooth_soundly.h"

#include "core/mesh/mesh_edges.h"
#include "core/mesh/self_intersection.h"

namespace angiomesh {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Freezes the surroundings of the triangles that came to meet; false when none did that were not
// frozen already.
bool freezeMeeting(const TriMesh& smoothed, const Pairs& pairs, std::vector<char>& frozen,
                   int rings) {
  std::vector<char> grown = frozen;
  bool any = false;
  for (const auto& pair : pairs) {
    for (const std::uint32_t triangle : {pair.first, pair.second}) {
      for (const std::uint32_t v : smoothed.triangles[triangle]) {
        any = any || frozen[v] == 0;
        grown[v] = 1;
      }
    }
  }
  if (!any) return false;
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> inner = grown;
    for (const auto& t : smoothed.triangles) {
      if (inner[t[0]] == 0 && inner[t[1]] == 0 && inner[t[2]] == 0) continue;
      for (const std::uint32_t v : t) grown[v] = 1;
    }
  }
  frozen.swap(grown);
  return true;
}

// Puts the components that meet anything back as they were, until none that was smoothed does.
void putBack(const TriMesh& mesh, TriMesh& smoothed, std::size_t& left, const Progress& progress) {
  const MeshComponents parts = meshComponents(mesh);
  std::vector<char> back(parts.count, 0);
  for (;;) {
    std::vector<char> now(parts.count, 0);
    bool any = false;
    for (const auto& [a, b] : selfIntersections(smoothed, progress))
      for (const std::uint32_t part : {parts.label[a], parts.label[b]}) {
        if (back[part] != 0) continue;
        if (now[part] == 0) ++left;
        now[part] = back[part] = 1;
        any = true;
      }
    if (!any) return;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (now[parts.label[t]] == 0) continue;
      smoothed.triangles[t] = mesh.triangles[t];
      for (const std::uint32_t v : mesh.triangles[t]) smoothed.points[v] = mesh.points[v];
    }
  }
}

}  // namespace

TriMesh smoothSoundly(const TriMesh& mesh,
                      const std::function<TriMesh(const std::vector<char>& frozen)>& smooth,
                      std::size_t& left, const Progress& progress) {
  std::vector<char> frozen(mesh.points.size(), 0);
  constexpr int attempts = 4;
  TriMesh smoothed;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    smoothed = smooth(frozen);
    const Pairs pairs = selfIntersections(smoothed, progress);
    if (pairs.empty()) return smoothed;
    if (freezeMeeting(smoothed, pairs, frozen, 1 << attempt)) continue;
    // What is frozen and meets did so before.
    if (!selfIntersections(mesh, progress).empty()) return smoothed;
    break;
  }
  putBack(mesh, smoothed, left, progress);
  return smoothed;
}

}  // namespace angiomesh

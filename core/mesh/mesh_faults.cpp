// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_faults.h"

#include <algorithm>
#include <map>

#include "core/base/formatted.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/self_intersection.h"

namespace angiomesh {

std::vector<std::uint32_t> brokenTriangles(const TriMesh& mesh,
                                           const std::function<bool(const EdgeSide&)>& mayEnd) {
  std::vector<std::uint32_t> broken;
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    if (end - i == 2 && sides[i].forward != sides[i + 1].forward) continue;
    if (end - i == 1 && mayEnd(sides[i])) continue;
    for (std::size_t k = i; k < end; ++k) broken.push_back(sides[k].triangle);
  }
  const std::vector<char> irregular = irregularVertices(mesh, sides);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (irregular[v] != 0) broken.push_back(t);
  std::sort(broken.begin(), broken.end());
  broken.erase(std::unique(broken.begin(), broken.end()), broken.end());
  return broken;
}

void locateFaults(const TriMesh& mesh, MeshFaults& faults) {
  DisjointSets sets(mesh.points.size());
  std::vector<std::uint32_t> faulty = faults.broken;
  for (const auto& [a, b] : faults.meeting) {
    faulty.insert(faulty.end(), {a, b});
    sets.join(mesh.triangles[a][0], mesh.triangles[b][0]);
  }
  std::sort(faulty.begin(), faulty.end());
  faulty.erase(std::unique(faulty.begin(), faulty.end()), faulty.end());
  for (const std::uint32_t t : faulty) {
    const auto& c = mesh.triangles[t];
    sets.join(c[0], c[1]);
    sets.join(c[0], c[2]);
  }
  struct Patch {
    std::size_t triangles = 0;
    Eigen::Vector3d sum{0.0, 0.0, 0.0};
  };
  std::map<std::uint32_t, Patch> patches;
  for (const std::uint32_t t : faulty) {
    Patch& patch = patches[sets.find(mesh.triangles[t][0])];
    ++patch.triangles;
    for (const std::uint32_t v : mesh.triangles[t]) patch.sum += mesh.points[v] / 3.0;
  }
  faults.places = patches.size();
  std::size_t most = 0;
  for (const auto& [vertex, patch] : patches) {
    if (patch.triangles <= most) continue;
    most = patch.triangles;
    faults.placeLps = patch.sum / static_cast<double>(patch.triangles);
  }
}

std::string MeshFaults::text() const {
  if (none()) return {};
  const char* what = broken.empty()    ? "cuts itself"
                     : meeting.empty() ? "is not closed or no manifold"
                                       : "cuts itself, or is not closed or no manifold,";
  return std::string(what) + " in " + std::to_string(places) +
         (places == 1 ? " place" : " places") + (places == 1 ? ", near " : ", such as near ") +
         placeText(placeLps);
}

MeshFaults findFaults(const TriMesh& mesh, bool closed, const Progress& progress) {
  MeshFaults faults;
  faults.meeting = selfIntersections(mesh, progress);
  faults.broken = brokenTriangles(mesh, [&](const EdgeSide&) { return !closed; });
  locateFaults(mesh, faults);
  return faults;
}

}  // namespace angiomesh

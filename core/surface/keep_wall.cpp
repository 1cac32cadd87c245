// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "core/quality/self_intersection.h"
#include "core/surface/sagitta_offset.h"
#include "core/surface/smoothing.h"
#include "core/surface/wall.h"
#include "core/surface/wall_smoother.h"

namespace angiomesh {
namespace {

// Freezes the surroundings of the triangles that came to meet; false when none did that were not
// frozen already.
bool freezeMeeting(const TriMesh& smoothed, std::vector<char>& frozen, int rings,
                   const Progress& progress) {
  std::vector<char> grown = frozen;
  bool any = false;
  for (const auto& pair : selfIntersections(smoothed, progress)) {
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

}  // namespace

TriMesh keepWallSmooth(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
                       const Progress& progress, const std::vector<Port>& ports) {
  progress.report(0.0);
  checkMesh(mesh);
  if (mesh.triangles.empty() || params.iterations <= 0) return mesh;
  std::vector<char> frozen(mesh.points.size(), 0);
  constexpr int attempts = 6;
  if (phi != nullptr && inscribedInZeroSet(mesh, *phi)) {
    for (int attempt = 0; attempt < attempts; ++attempt) {
      TriMesh moved = offsetBySagitta(mesh, *phi, ports, frozen, progress);
      if (!freezeMeeting(moved, frozen, attempt < 2 ? 1 : 3, progress.sub(0.5, 0.95))) {
        progress.report(1.0);
        return moved;
      }
    }
    return mesh;
  }
  std::unique_ptr<Wall> wall;
  if (phi != nullptr) {
    wall = std::make_unique<ZeroSetWall>(*phi);
  } else {
    wall = std::make_unique<MeshWall>(mesh, params.wallBoundVoxels, progress);
  }
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const double from = attempt == 0 ? 0.0 : 0.9;
    TriMesh smoothed = WallSmoother(mesh, params, phi, *wall, ports, frozen)
                           .run(progress.sub(from, attempt == 0 ? 0.85 : 0.95));
    if (!freezeMeeting(smoothed, frozen, attempt < 2 ? 1 : 3, progress.sub(0.85, 0.9))) {
      progress.report(1.0);
      return smoothed;
    }
  }
  return mesh;
}

}  // namespace angiomesh

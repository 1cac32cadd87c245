// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "core/mesh/mesh_edges.h"
#include "core/smooth/sagitta_offset.h"
#include "core/smooth/smooth_soundly.h"
#include "core/smooth/smoothing.h"
#include "core/smooth/wall.h"
#include "core/smooth/wall_smoother.h"

namespace angiomesh {
namespace {

/// Some of a mesh's components, with all its points.
struct Selection {
  TriMesh mesh;
  std::vector<std::uint32_t> triangles;  ///< their numbers in the whole

  Selection(const TriMesh& whole, const std::vector<char>& wanted) {
    mesh.points = whole.points;
    for (std::uint32_t t = 0; t < whole.triangles.size(); ++t) {
      if (wanted[t] == 0) continue;
      triangles.push_back(t);
      mesh.triangles.push_back(whole.triangles[t]);
      if (!whole.patch.empty()) mesh.patch.push_back(whole.patch[t]);
    }
  }

  // Gives the whole the triangles, and the points that they use, of a changed `mesh`.
  void putInto(TriMesh& whole, const TriMesh& changed) const {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      whole.triangles[triangles[i]] = changed.triangles[i];
      for (const std::uint32_t v : changed.triangles[i]) whole.points[v] = changed.points[v];
    }
  }
};

// Per triangle: 1 in the components that are inscribed in the zero set.
std::vector<char> inscribedParts(const TriMesh& mesh, const SplineField* phi) {
  std::vector<char> inscribed(mesh.triangles.size(), 0);
  if (phi == nullptr) return inscribed;
  if (inscribedInZeroSet(mesh, *phi)) {
    inscribed.assign(inscribed.size(), 1);
    return inscribed;
  }
  const MeshComponents parts = meshComponents(mesh);
  if (parts.count < 2) return inscribed;
  const std::vector<char> good = inscribedComponents(mesh, parts, *phi);
  for (std::size_t t = 0; t < inscribed.size(); ++t) inscribed[t] = good[parts.label[t]];
  return inscribed;
}

}  // namespace

TriMesh keepWallSmooth(const TriMesh& mesh, const SmoothParams& params, const SplineField* phi,
                       const Progress& progress, const std::vector<Port>& ports,
                       std::size_t* left) {
  progress.report(0.0);
  checkMesh(mesh);
  if (mesh.triangles.empty() || params.iterations <= 0) return mesh;
  std::vector<char> wanted = inscribedParts(mesh, phi);
  const Selection inscribed(mesh, wanted);
  for (char& w : wanted) w = w == 0 ? 1 : 0;
  const Selection others(mesh, wanted);
  std::unique_ptr<Wall> wall;
  if (phi != nullptr)
    wall = std::make_unique<ZeroSetWall>(*phi);
  else
    wall = std::make_unique<MeshWall>(mesh, params.wallBoundVoxels, progress);
  const auto smooth = [&](const std::vector<char>& frozen) {
    TriMesh result = mesh;
    if (!inscribed.triangles.empty())
      inscribed.putInto(
          result, offsetBySagitta(inscribed.mesh, *phi, ports, frozen, progress.sub(0.0, 0.1)));
    if (!others.triangles.empty()) {
      const WallPlaces places(others.mesh, phi, ports, frozen);
      const WallGround ground(*wall, places);
      const Progress part = progress.sub(0.1, 0.85);
      others.putInto(result, WallSmoother(places, ground, *wall, params, part).run());
    }
    return result;
  };
  std::size_t count = 0;
  TriMesh smoothed = smoothSoundly(mesh, smooth, count, progress.sub(0.85, 0.95));
  if (left != nullptr) *left += count;
  progress.report(1.0);
  return smoothed;
}

}  // namespace angiomesh

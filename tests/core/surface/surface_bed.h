// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>

#include "core/contour/reference_surface.h"
#include "core/front/grow_front.h"
#include "core/mesh/tri_mesh.h"
#include "core/remesh/remesh.h"
#include "core/surface/sound_surface.h"
#include "core/surface/surface_check.h"
#include "tests/core/mesh_shapes.h"

// What meshes of a zero set are made and checked on.
namespace angiomesh {

/// A field with all that meshZeroSet() makes of it before it meshes.
struct SurfaceBed {
  SplineField field;
  SurfaceBorder border;
  EndPlanes ends;
  GuidanceField size;
  PatchMesh reference;
  Landmarks landmarks;

  explicit SurfaceBed(const Volume<float>& phi, SurfaceBorder rim = SurfaceBorder::Cap,
                      double rho = 0.4)
      : field(phi, SplineKind::InterpolatingBspline),
        border(rim),
        ends(phi.geometry),
        size(field, SizingParams::printed(rho)),
        reference(referenceSurface(sampleField(field, wholeGrid(phi.geometry)), ends, border)),
        landmarks(landmarksOf(wallOf(reference), field, size)) {}

  /// The front's mesh, with improved triangles.
  [[nodiscard]] PatchMesh grown() const {
    PatchMesh mesh = growFront(landmarks, field, size, ends, {}, border, {});
    improveTriangles(mesh, field, size, ends);
    return mesh;
  }
  [[nodiscard]] SurfaceCheck checked(const PatchMesh& mesh) const {
    SurfaceCheck check = checkReach(mesh, field, size, landmarks, border);
    finishCheck(check, mesh, field, {});
    return check;
  }
  /// As the mesh of a front.
  [[nodiscard]] SoundSurface sound(const PatchMesh& mesh) const {
    const SurfaceGround ground{reference, landmarks, field, size, ends, border};
    return makeSound(mesh, SurfaceMethod::AdvancingFront,
                     checkReach(mesh, field, size, landmarks, border), ground, {});
  }
};

inline Volume<float> ballsField(const std::vector<std::pair<Eigen::Vector3d, double>>& balls,
                                const Geometry& grid) {
  return analytic::sampled(grid, [&](const Eigen::Vector3d& p) {
    double least = 1e9;
    for (const auto& [centre, radius] : balls)
      least = std::min(least, analytic::ball(p, centre, radius));
    return least;
  });
}

inline PatchMesh patchOf(const TriMesh& mesh) {
  PatchMesh patch;
  patch.mesh = mesh;
  patch.patch.assign(mesh.triangles.size(), 0);
  patch.place.assign(mesh.points.size(), Place::onWall());
  patch.origin.assign(mesh.triangles.size(), FaceOrigin::Front);
  return patch;
}

/// A ball as 20 * 4^levels triangles that face outward.
inline PatchMesh ballPatch(const Eigen::Vector3d& centre, double radius, int levels) {
  TriMesh mesh = shapes::icosphere(levels);
  for (Eigen::Vector3d& p : mesh.points) p = centre + radius * p;
  if (enclosedVolumeMm3(mesh) < 0.0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return patchOf(mesh);
}

inline void appendPatch(PatchMesh& to, const PatchMesh& from) {
  shapes::append(to.mesh, from.mesh);
  to.place.insert(to.place.end(), from.place.begin(), from.place.end());
  to.patch.insert(to.patch.end(), from.patch.begin(), from.patch.end());
  to.origin.insert(to.origin.end(), from.origin.begin(), from.origin.end());
}

inline void addTriangle(PatchMesh& mesh, const std::array<std::uint32_t, 3>& corners) {
  mesh.mesh.triangles.push_back(corners);
  mesh.patch.push_back(0);
  mesh.origin.push_back(FaceOrigin::Front);
}

}  // namespace angiomesh

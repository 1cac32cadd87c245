// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/zero_set_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "core/base/error.h"
#include "core/quality/self_intersection.h"
#include "core/surface/clip_reference.h"
#include "core/surface/grow_front.h"
#include "core/surface/mend_mesh.h"
#include "core/surface/port_patches.h"
#include "core/surface/reference_surface.h"
#include "core/surface/remesh.h"
#include "core/surface/surface_check.h"

namespace angiomesh {
namespace {

constexpr std::uint32_t none = SurfaceCheck::none;

void append(PatchMesh& to, const PatchMesh& from) {
  const auto offset = static_cast<std::uint32_t>(to.mesh.points.size());
  to.mesh.points.insert(to.mesh.points.end(), from.mesh.points.begin(), from.mesh.points.end());
  to.place.insert(to.place.end(), from.place.begin(), from.place.end());
  to.patch.insert(to.patch.end(), from.patch.begin(), from.patch.end());
  to.origin.insert(to.origin.end(), from.origin.begin(), from.origin.end());
  for (const auto& t : from.mesh.triangles)
    to.mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

class Mesher {
 public:
  Mesher(const SplineField& field, const GuidanceField& size, const SizingParams& sizing,
         SurfaceBorder border, const CutAway& away, const Progress& progress)
      : field_(field),
        sizing_(sizing),
        border_(border),
        away_(away),
        ends_(field.geometry(), away.planes()),
        progress_(progress),
        size_(size) {
    reference_ = referenceSurface(sampleField(field, wholeGrid(field.geometry()), progress), ends_,
                                  border, progress.sub(0.15, 0.2));
    clipReference(reference_, away, field, size_, ends_, border, progress);
    landmarks_ = landmarksOf(wallOf(reference_), field, size_);
    progress_.report(0.25);
  }

  ZeroSetMesh run(SurfaceMethod method) {
    PatchMesh mesh;
    if (method == SurfaceMethod::Remesh) {
      mesh = remesh(reference_, field_, size_, ends_, progress_.sub(0.25, 0.9));
    } else {
      mesh = growFront(landmarks_, field_, size_, ends_, away_, chordAngle(), border_, progress_);
      progress_.report(0.5);
      mendBroken(mesh);
      dropBroken(mesh);
      improveTriangles(mesh, field_, size_, ends_, progress_.sub(0.5, 0.8));
    }
    SurfaceCheck check = checkSurface(mesh, field_, size_, landmarks_, border_, progress_);
    progress_.report(0.9);
    if (method == SurfaceMethod::AdvancingFront && addMissing(mesh, check))
      check = checkSurface(mesh, field_, size_, landmarks_, border_, progress_);
    if (!allVerified(check) && untangle(mesh))
      check = checkSurface(mesh, field_, size_, landmarks_, border_, progress_);
    progress_.report(1.0);
    return result(std::move(mesh), check);
  }

 private:
  [[nodiscard]] double chordAngle() const {
    const double angle = 2.0 * std::sin(0.5 * sizing_.rho) * sizing_.curvatureRelax;
    return sizing_.etaCompensated ? angle : angle * sizing_.etaInverse;
  }

  static bool allVerified(const SurfaceCheck& check) {
    return std::all_of(check.components.begin(), check.components.end(),
                       [](const SurfaceComponent& c) { return c.verified; });
  }

  // Where fronts met in a way that leaves no manifold, which takes a zero set that all but touches
  // itself, the place is filled anew.
  void mendBroken(PatchMesh& mesh) const {
    for (int rings = 0; rings < 5; ++rings) {
      const std::vector<std::uint32_t> broken =
          brokenTriangles(mesh, border_ == SurfaceBorder::Open);
      if (broken.empty()) return;
      mendMesh(mesh, broken, rings, field_);
    }
  }

  // Fills anew where triangles meet; a verified component has no such place. True when something
  // was changed.
  bool untangle(PatchMesh& mesh) const {
    constexpr int attempts = 6, improved = 3;
    bool changed = false;
    std::vector<std::uint32_t> meeting = intersecting(mesh);
    for (int n = 0; n < attempts && !meeting.empty(); ++n) {
      if (!mendMesh(mesh, meeting, n, field_)) continue;
      changed = true;
      // What improving ties up again stays as it was filled.
      if (n < improved) improveTriangles(mesh, field_, size_, ends_, progress_);
      meeting = intersecting(mesh);
    }
    return changed;
  }

  [[nodiscard]] std::vector<std::uint32_t> intersecting(const PatchMesh& mesh) const {
    std::vector<std::uint32_t> found;
    for (const auto& [a, b] : selfIntersections(mesh.mesh, progress_)) {
      found.push_back(a);
      found.push_back(b);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  // Takes out components that are no manifolds, or not closed: improving them makes no sense.
  void dropBroken(PatchMesh& mesh) const {
    const SurfaceCheck check = checkManifold(mesh, border_);
    if (std::all_of(check.components.begin(), check.components.end(),
                    [](const SurfaceComponent& c) { return c.why.empty(); }))
      return;
    mesh = selectTriangles(
        mesh, [&](std::uint32_t t) { return check.components[check.parts.label[t]].why.empty(); });
  }

  // Remeshes marching cubes' components that no part of the front's mesh reaches. A part whose
  // topology differs from marching cubes' stays, in doubt: on a noisy field either may be right.
  bool addMissing(PatchMesh& mesh, const SurfaceCheck& check) const {
    const MeshComponents parts = meshComponents(reference_.mesh);
    std::vector<std::uint32_t> partOfPoint(reference_.mesh.points.size(), none);
    for (std::size_t t = 0; t < parts.label.size(); ++t)
      for (const std::uint32_t v : reference_.mesh.triangles[t]) partOfPoint[v] = parts.label[t];
    std::vector<char> missing(parts.count, 0);
    for (const SurfaceCheck::Reached& r : check.reached)
      if (r.part == none) missing[partOfPoint[r.component]] = 1;
    if (std::find(missing.begin(), missing.end(), 1) == missing.end()) return false;
    const PatchMesh start =
        selectTriangles(reference_, [&](std::uint32_t t) { return missing[parts.label[t]] != 0; });
    append(mesh, remesh(start, field_, size_, ends_, progress_.sub(0.9, 0.98)));
    return true;
  }

  ZeroSetMesh result(PatchMesh mesh, const SurfaceCheck& check) const {
    ZeroSetMesh out;
    out.estimatedTriangles = size_.estimatedTriangles();
    out.components = check.components;
    std::stable_sort(
        out.components.begin(), out.components.end(),
        [](const SurfaceComponent& a, const SurfaceComponent& b) { return a.areaMm2 > b.areaMm2; });
    for (const SurfaceCheck::Reached& r : check.reached) {
      if (r.part != none) continue;
      const Eigen::Vector3d& p = landmarks_.points[r.component].point;
      char text[160];
      std::snprintf(
          text, sizeof text,
          "a component of the zero set near L %.1f P %.1f S %.1f mm, too small for a mesh", p.x(),
          p.y(), p.z());
      out.dropped.emplace_back(text);
    }
    const auto fromFront = std::count(mesh.origin.begin(), mesh.origin.end(), FaceOrigin::Front);
    if (!mesh.origin.empty())
      out.fromFrontPercent =
          100.0 * static_cast<double>(fromFront) / static_cast<double>(mesh.origin.size());
    out.origin = mesh.origin;
    out.ports = numberPatches(mesh, ends_, away_);
    out.mesh = std::move(mesh.mesh);
    return out;
  }

  const SplineField& field_;
  const SizingParams& sizing_;
  SurfaceBorder border_;
  const CutAway& away_;
  EndPlanes ends_;
  const Progress& progress_;
  const GuidanceField& size_;
  PatchMesh reference_;
  Landmarks landmarks_;
};

}  // namespace

ZeroSetMesh meshZeroSet(const SplineField& field, const SizingParams& sizing, SurfaceMethod method,
                        SurfaceBorder border, const Progress& progress, const CutAway& away) {
  if (method == SurfaceMethod::MarchingCubes)
    throw InputError("marching cubes makes no sized triangles", "surface.method",
                     "use advancing-front or remesh");
  const GuidanceField size(field, sizing, progress.sub(0.0, 0.15), &away);
  return meshZeroSet(field, size, sizing, method, border, progress, away);
}

ZeroSetMesh meshZeroSet(const SplineField& field, const GuidanceField& size,
                        const SizingParams& sizing, SurfaceMethod method, SurfaceBorder border,
                        const Progress& progress, const CutAway& away) {
  return Mesher(field, size, sizing, border, away, progress).run(method);
}

}  // namespace angiomesh

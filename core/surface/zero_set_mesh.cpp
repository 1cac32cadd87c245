// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/zero_set_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/contour/port_patches.h"
#include "core/contour/reference_surface.h"
#include "core/cuts/clip_reference.h"
#include "core/front/grow_front.h"
#include "core/front/mend_mesh.h"
#include "core/mesh/mesh_faults.h"
#include "core/remesh/remesh.h"
#include "core/surface/sound_surface.h"
#include "core/surface/surface_check.h"

namespace angiomesh {
namespace {

constexpr std::uint32_t none = SurfaceCheck::none;

class Mesher {
 public:
  Mesher(const SplineField& field, const GuidanceField& size, SurfaceBorder border,
         const CutAway& away, const Progress& progress)
      : field_(field),
        border_(border),
        away_(away),
        ends_(field.geometry(), away.planes()),
        progress_(progress),
        size_(size) {
    reference_ = referenceSurface(sampleField(field, wholeGrid(field.geometry()), progress), ends_,
                                  border, progress.sub(0.15, 0.2));
    clipReference(reference_, away, field.geometry().voxelMm(), progress);
    if (border == SurfaceBorder::Cap)
      capCuts(reference_, away.sections.size(), field, size_, ends_, progress);
    landmarks_ = landmarksOf(wallOf(reference_), field, size_);
    progress_.report(0.25);
  }

  ZeroSetMesh run(SurfaceMethod method) {
    PatchMesh mesh;
    if (method == SurfaceMethod::Remesh) {
      PatchMesh start = reference_;
      start.group = meshComponents(reference_.mesh).label;
      mesh = remesh(start, field_, size_, ends_, progress_.sub(0.25, 0.8));
    } else {
      mesh = growFront(landmarks_, field_, size_, ends_, away_, border_, progress_);
      progress_.report(0.5);
      if (!mendBroken(mesh)) dropBroken(mesh, border_);
      improveTriangles(mesh, field_, size_, ends_, progress_.sub(0.5, 0.8));
    }
    const SurfaceGround ground{reference_, landmarks_, field_, size_, ends_, border_};
    SurfaceCheck check = checkReach(mesh, field_, size_, landmarks_, border_);
    SoundSurface sound = makeSound(std::move(mesh), method, check, ground, progress_);
    progress_.report(0.9);
    if (sound.changed) check = checkReach(sound.mesh, field_, size_, landmarks_, border_);
    finishCheck(check, sound.mesh, field_, progress_);
    progress_.report(1.0);
    return result(std::move(sound), check);
  }

 private:
  // Where fronts met in a way that leaves no manifold, which takes a zero set that all but touches
  // itself, the place is filled anew. True when nothing broken is left.
  bool mendBroken(PatchMesh& mesh) const {
    for (int rings = 0; rings < 5; ++rings) {
      const std::vector<std::uint32_t> broken =
          brokenTriangles(mesh, border_ == SurfaceBorder::Open);
      if (broken.empty()) return true;
      mendMesh(mesh, broken, rings, field_);
    }
    return false;
  }

  ZeroSetMesh result(SoundSurface sound, const SurfaceCheck& check) const {
    PatchMesh& mesh = sound.mesh;
    ZeroSetMesh out;
    out.estimatedTriangles = size_.estimatedTriangles();
    out.components = check.components;
    for (std::size_t t = 0; t < mesh.group.size(); ++t) {
      const SurfaceGroup& group = sound.groups[mesh.group[t]];
      SurfaceComponent& component = out.components[check.parts.label[t]];
      component.method = group.method;
      component.instead = group.instead;
      component.faults = group.faults;
      if (!group.faults.empty()) component.verified = false;
      if (component.why.empty()) component.why = group.faults;
    }
    out.dropped = std::move(sound.dropped);
    std::stable_sort(
        out.components.begin(), out.components.end(),
        [](const SurfaceComponent& a, const SurfaceComponent& b) { return a.areaMm2 > b.areaMm2; });
    for (const SurfaceCheck::Reached& r : check.reached) {
      if (r.part != none) continue;
      out.dropped.push_back("a component of the zero set near " +
                            placeText(landmarks_.points[r.component].point) +
                            ", too small for a mesh");
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
  return meshZeroSet(field, size, method, border, progress, away);
}

ZeroSetMesh meshZeroSet(const SplineField& field, const GuidanceField& size, SurfaceMethod method,
                        SurfaceBorder border, const Progress& progress, const CutAway& away) {
  return Mesher(field, size, border, away, progress).run(method);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/surface_step.h"

#include <algorithm>
#include <utility>

#include "core/base/few_warnings.h"
#include "core/base/formatted.h"
#include "core/contour/marching_cubes.h"
#include "core/contour/port_patches.h"
#include "core/contour/reference_surface.h"
#include "core/cuts/clip_reference.h"
#include "core/front/grow_front.h"
#include "core/pipeline/segments.h"
#include "core/sizing/guidance_field.h"

namespace angiomesh {
namespace {

/// In cells of cellVoxels, divided at the cuts, with caps of triangles of the wanted size.
MadeSurface clippedMarchingCubes(const SplineField& field, const SurfaceParams& params,
                                 const CutAway& away, const Progress& progress) {
  const EndPlanes ends(field.geometry(), away.planes());
  const GuidanceField size(field, params.sizing, progress.sub(0.0, 0.3), &away);
  const double cellMm = params.cellVoxels * field.geometry().voxelMm();
  PatchMesh mesh = referenceSurface(resampleField(field, cellMm, progress), ends, params.border,
                                    progress.sub(0.3, 0.6));
  clipReference(mesh, away, field.geometry().voxelMm(), progress);
  if (params.border == SurfaceBorder::Cap)
    capCuts(mesh, away.sections.size(), field, size, ends, progress.sub(0.6, 1.0));
  MadeSurface made;
  made.ports = numberPatches(mesh, ends, away);
  made.mesh = std::move(mesh.mesh);
  return made;
}

MadeSurface byMarchingCubes(const Volume<float>& phi, const SplineField& field,
                            const SurfaceParams& params, const CutAway& away,
                            const Progress& progress) {
  MadeSurface made;
  if (!away.empty()) return clippedMarchingCubes(field, params, away, progress);
  if (params.cellVoxels == 1.0) {
    made.mesh = marchingCubes(phi, params.border, progress);
  } else {
    const double cellMm = params.cellVoxels * phi.geometry.voxelMm();
    made.mesh = marchingCubes(resampleField(field, cellMm, progress.sub(0.0, 0.5)), params.border,
                              progress.sub(0.5, 1.0));
  }
  return made;
}

MadeSurface bySize(const SplineField& field, const SurfaceParams& params, const CutAway& away,
                   const Progress& progress, const Expectation& expect) {
  const GuidanceField size(field, params.sizing, progress.sub(0.0, 0.15), &away);
  MadeSurface made;
  if (expect) {
    const ExpectedSurface expected = expect(size);
    made.origin.estimatedTriangles = expected.triangles;
    made.origin.smoothTriangles = expected.smoothTriangles;
  }
  ZeroSetMesh zeroSet =
      meshZeroSet(field, size, params.method, params.border, progress.sub(0.0, 1.0), away);
  made.mesh = std::move(zeroSet.mesh);
  made.origin.components = std::move(zeroSet.components);
  if (!expect) made.origin.estimatedTriangles = zeroSet.estimatedTriangles;
  made.origin.dropped = std::move(zeroSet.dropped);
  made.ports = std::move(zeroSet.ports);
  return made;
}

std::string methodText(SurfaceMethod method) {
  switch (method) {
    case SurfaceMethod::AdvancingFront:
      return "the advancing front";
    case SurfaceMethod::Remesh:
      return "remeshing";
    case SurfaceMethod::MarchingCubes:
      break;
  }
  return "marching cubes";
}

/// The share of all triangles, from those of the components.
double fromFront(const std::vector<SurfaceComponent>& components) {
  double sum = 0.0, count = 0.0;
  for (const SurfaceComponent& part : components) {
    sum += part.fromFrontPercent * static_cast<double>(part.triangles);
    count += static_cast<double>(part.triangles);
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// What is to be said of a handle; nothing of one that is most likely real.
std::string remarkOn(const Handle& handle) {
  if (handle.kind == HandleKind::Loop) return {};
  const bool hole = handle.kind == HandleKind::Hole;
  const std::string place = placeText(hole ? handle.centreLps : handle.placeLps);
  return formatted(hole ? "a hole of %.3g mm around goes through a vessel near %s: that is smaller "
                          "than the voxels tell"
                        : "a loop of %.3g mm closes near %s through a place less than half a voxel "
                          "deep: vessels may only touch there",
                   handle.lengthMm, place.c_str());
}

void addHandles(SurfaceOrigin& origin, const Volume<float>& phi, const CutAway& away,
                const Progress& progress) {
  if (std::all_of(origin.components.begin(), origin.components.end(),
                  [](const SurfaceComponent& part) { return part.genus() == 0; }))
    return;
  origin.handles = handlesOf(phi, progress);
  if (!away.empty())
    std::erase_if(origin.handles, [&](const Handle& h) { return away.takenAt(h.placeLps); });
}

}  // namespace

std::size_t SurfaceOrigin::unverified() const {
  return static_cast<std::size_t>(
      std::count_if(components.begin(), components.end(),
                    [](const SurfaceComponent& part) { return !part.verified; }));
}

std::string SurfaceOrigin::fault() const {
  for (std::size_t i = 0; i < components.size(); ++i)
    if (!components[i].faults.empty())
      return "surface component " + std::to_string(i + 1) + " " + components[i].faults;
  return {};
}

std::vector<std::string> SurfaceOrigin::warnings() const {
  std::vector<std::string> replaced, unsure, left, small;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const SurfaceComponent& part = components[i];
    const std::string name = "surface component " + std::to_string(i + 1) + " (" +
                             std::to_string(part.triangles) + " triangles)";
    if (!part.instead.empty())
      replaced.push_back(name + " was made by " + methodText(part.method) + ": " + part.instead);
    if (!part.verified) unsure.push_back(name + " is not verified: " + part.why);
  }
  for (const std::string& piece : dropped) left.push_back("left out of the surface: " + piece);
  for (const Handle& handle : handles)
    if (std::string remark = remarkOn(handle); !remark.empty()) small.push_back(std::move(remark));
  std::vector<std::string> list;
  addFew(list, replaced, " more surface components were made by another method");
  addFew(list, unsure, " more surface components are not verified");
  addFew(list, left, " more pieces were left out of the surface", lostCuts + kNamedWarnings);
  addFew(list, small, " more holes and loops are smaller than the voxels tell");
  return list;
}

MadeSurface makeSurface(const Volume<float>& phi, const SplineField& field,
                        const SurfaceParams& params, const Progress& progress, const CutAway& away,
                        bool largestAlone, const Expectation& expect) {
  MadeSurface made = params.method == SurfaceMethod::MarchingCubes
                         ? byMarchingCubes(phi, field, params, away, progress)
                         : bySize(field, params, away, progress, expect);
  SurfaceOrigin& origin = made.origin;
  origin.method = params.method;
  if (const int count = dropSmallComponents(made.mesh, params.minComponentMm3); count > 0) {
    origin.dropped.push_back(std::to_string(count) + " components below surface.minComponentMm3");
    std::erase_if(origin.components, [&](const SurfaceComponent& part) {
      return part.volumeMm3 < params.minComponentMm3;
    });
  }
  // Parts that voxels connect but the surface does not, and bubbles inside.
  if (const int count = largestAlone ? keepLargestComponent(made.mesh) : 0; count > 0) {
    origin.dropped.push_back(std::to_string(count) + " components beside the largest");
    if (origin.components.size() > 1) origin.components.resize(1);
  }
  if (!origin.dropped.empty()) {
    made.lostCuts = dropLostPorts(made.mesh, made.ports, away.sections.size());
    std::vector<std::string> lost;
    for (const std::size_t cut : made.lostCuts)
      lost.push_back(away.nameOf(cut) + " with the part that it ends");
    origin.dropped.insert(origin.dropped.begin(), lost.begin(), lost.end());
    origin.lostCuts = lost.size();
  }
  addHandles(origin, phi, away, progress);
  if (params.method == SurfaceMethod::AdvancingFront)
    origin.fromFrontPercent = fromFront(origin.components);
  return made;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/surface_result.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/cuts/border_slant.h"
#include "core/field/wall_field.h"
#include "core/pipeline/expected_surface.h"
#include "core/pipeline/segments.h"

namespace angiomesh {

SurfaceResult surfaceOf(const EvolveResult& evolved, const Parameters& params,
                        const Progress& progress, std::vector<std::string>& warnings,
                        const std::function<void(const std::string&)>& warned) {
  const SurfaceParams& p = params.surface;
  SurfaceResult result;
  Segments segments = selectSegments(*evolved.phi, params.segmentation, params.seeds.points,
                                     progress.sub(0.0, 0.1));
  result.uncutPhi = withoutDropped(evolved.phi, segments, progress.sub(0.1, 0.14));
  result.components = std::move(segments.components);
  result.insideVoxels = segments.insideVoxels;
  const SplineField field = wallField(*result.uncutPhi, p.spline);
  const CutAway away =
      makeCuts(field, *result.uncutPhi, params.ports, warnings, progress.sub(0.14, 0.18));
  result.phi = result.uncutPhi;
  if (!away.empty()) {
    result.phi = std::make_shared<const Volume<float>>(
        phiWithout(*result.uncutPhi, away, progress.sub(0.18, 0.2)));
    result.insideVoxels =
        static_cast<std::size_t>(std::count_if(result.phi->voxels.begin(), result.phi->voxels.end(),
                                               [](float value) { return value < 0.0F; }));
  }
  result.marchingCubes =
      std::make_shared<const TriMesh>(marchingCubes(*result.phi, p.border, progress.sub(0.2, 0.3)));
  const bool largestAlone = params.segmentation.keep == KeepComponents::Largest;
  if (p.method == SurfaceMethod::MarchingCubes && p.cellVoxels == 1.0 && p.minComponentMm3 == 0.0 &&
      !largestAlone && away.empty()) {
    result.mesh = result.marchingCubes;
    return result;
  }
  const auto expect = [&](const GuidanceField& size) {
    const ExpectedSurface expected = expectSurface(field, size, p, result.components, away);
    checkExpected(expected, p);
    for (const std::string& warning : warningsOf(expected)) {
      warned(warning);
      warnings.push_back(warning);
    }
    return expected;
  };
  MadeSurface made =
      makeSurface(*result.uncutPhi, field, p, progress.sub(0.3, 1.0), away, largestAlone, expect);
  if (made.mesh.triangles.empty())
    throw NumericError("no surface component is left", "surface",
                       "lower surface.minComponentMm3 or surface.cellVoxels, or choose another "
                       "surface.method");
  for (std::string& warning : made.origin.warnings()) warnings.push_back(std::move(warning));
  result.mesh = std::make_shared<const TriMesh>(std::move(made.mesh));
  result.origin = std::move(made.origin);
  result.ports = std::move(made.ports);
  measureSlants(field, *result.uncutPhi, result.ports);
  for (std::size_t n = 0; n < away.sections.size(); ++n) {
    if (std::count(made.lostCuts.begin(), made.lostCuts.end(), n) == 0)
      result.sectionAreasMm2.push_back(away.sections[n].areaMm2);
  }
  if (const std::size_t parts = result.origin.components.size(); !away.empty() && parts > 1)
    warnings.push_back("the surface has " + std::to_string(parts) +
                       " parts that are not connected: a flow solver takes one (see "
                       "segmentation.keep)");
  return result;
}

}  // namespace angiomesh

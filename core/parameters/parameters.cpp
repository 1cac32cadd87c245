// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/parameters.h"

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/parameters/field.h"

namespace angiomesh {

void validate(const Parameters& params) {
  checkPartners(params);
  checkPorts(params.ports);
  if (!params.seeds.automatic && params.seeds.points.empty() && !isSegmented(params))
    throw InputError("there are no seeds", "seeds.automatic, seeds.points",
                     "give seeds by hand or turn seeds.automatic on");
}

bool evolves(const Parameters& params) {
  return params.segmentation.method == SegmentationMethod::LevelSet ||
         params.segmentation.method == SegmentationMethod::GeodesicActiveContour;
}

bool isSegmented(const Parameters& params) {
  return params.segmentation.method == SegmentationMethod::Label;
}

const std::vector<std::string>& presetNames() {
  static const std::vector<std::string> names{"angiomesh", "ct", "thesis"};
  return names;
}

Parameters preset(std::string_view name) {
  Parameters params;
  if (name == "angiomesh") return params;
  if (name == "ct") {
    // HU: fat and air are as good as soft tissue, contrast medium in a vessel is below 500.
    params.preprocess.clampLower = 0.0;
    params.preprocess.clampUpper = 500.0;
    return params;
  }
  if (name != "thesis")
    throw InputError("there is no preset '" + std::string(name) + "'", "preset",
                     "use one of " + joined(presetNames()));
  params.vesselness.scaleRule = ScaleRule::Difference;
  params.vesselness.scalesFromImage = false;
  params.vesselness.contrast = ContrastRule::Range;
  params.seeds.least = 0.0;
  params.levelset.start = StartRule::Seeds;
  params.levelset.acrossCrests = false;
  params.levelset.stepVoxels = 0.1667;
  params.levelset.maxIterations = 5000;
  params.levelset.checkEvery = 100;
  params.thresholds.bRule = ThresholdRule::Average;
  params.lumen.enabled = false;
  params.wall.enabled = false;
  params.surface.spline = SplineKind::Bspline;
  params.surface.sizing = SizingParams::printed();
  params.surface.border = SurfaceBorder::Open;
  params.smooth.method = SmoothMethod::Taubin;
  return params;
}

}  // namespace angiomesh

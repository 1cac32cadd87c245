// SPDX-License-Identifier: BSD-3-Clause
#include "core/parameters/presets.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/formatted.h"

namespace angiomesh {
namespace {

/// HU: fat and air are as good as soft tissue, contrast medium in a vessel is below 500.
void expectHounsfield(Parameters& params) {
  params.preprocess.clampLower = 0.0;
  params.preprocess.clampUpper = 500.0;
}

/// Of a region of the body. The thinnest vessel is left to the voxels.
/// @param thickestMm diameter of its thickest vessel   @param shortestMm what is shorter than this
/// and connected to nothing is no vessel
void expectVessels(Parameters& params, double thickestMm, double shortestMm) {
  params.vesselness.sigmaMaxMm = 0.5 * thickestMm;
  params.segmentation.minLengthMm = shortestMm;
}

Parameters thesisParameters() {
  Parameters params;
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

std::vector<Preset> makePresets() {
  Parameters ct;
  expectHounsfield(ct);
  // Internal carotid and basilar arteries are 3 to 6 mm wide, most sinuses wider.
  Parameters head;
  expectVessels(head, 6.0, 10.0);
  Parameters headCta = head;
  expectHounsfield(headCta);
  Parameters abdomen;
  expectVessels(abdomen, 25.0, 30.0);
  Parameters legs;
  expectVessels(legs, 12.0, 30.0);
  return {
      {"angiomesh",
       "The default: any MR angiography in which vessels are the brightest thing.",
       {}},
      {"ct", "Any CT angiography in HU: bone and what is darker than water are put aside.", ct},
      {"brain-tof",
       "Time-of-flight MR angiography of the brain: vessels up to 6 mm wide; separate parts "
       "shorter "
       "than 10 mm are left out.",
       head},
      {"abdominal-mra",
       "Contrast-enhanced MR angiography of the abdomen: vessels up to 25 mm wide; separate parts "
       "shorter than 30 mm are left out.",
       abdomen},
      {"peripheral-mra",
       "Contrast-enhanced MR angiography of pelvis and legs: vessels up to 12 mm wide; separate "
       "parts shorter than 30 mm are left out.",
       legs},
      {"head-cta",
       "CT angiography of the head in HU: as ct, vessels up to 6 mm wide; separate parts shorter "
       "than 10 mm are left out.",
       headCta},
      {"thesis", "The method as printed in the thesis, for comparison: slower and less accurate.",
       thesisParameters()},
  };
}

}  // namespace

const std::vector<Preset>& shippedPresets() {
  static const std::vector<Preset> presets = makePresets();
  return presets;
}

const std::vector<std::string>& presetNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Preset& preset : shippedPresets()) all.push_back(preset.name);
    return all;
  }();
  return names;
}

Parameters preset(std::string_view name) {
  const auto& all = shippedPresets();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Preset& one) { return one.name == name; });
  if (found == all.end())
    throw InputError("there is no preset '" + std::string(name) + "'", "preset",
                     "use one of " + joined(presetNames()));
  return found->params;
}

}  // namespace angiomesh

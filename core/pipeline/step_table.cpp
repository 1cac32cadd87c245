// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/step_table.h"

#include <utility>

#include "core/cuts/border_slant.h"
#include "core/field/wall_field.h"
#include "core/pipeline/evolve_step.h"
#include "core/pipeline/segmentation_doubts.h"
#include "core/pipeline/surface_result.h"
#include "core/pipeline/vesselness_step.h"

namespace angiomesh {
namespace {

template <class T>
StepValue shared(T value) {
  return std::make_shared<const T>(std::move(value));
}

StepValue preprocessStep(StepWork& work) {
  PreprocessParams params = work.params().preprocess;
  if (isSegmented(work.params())) {
    // Resampling and filters would make other values of labels.
    const auto roi = params.roi;
    params = {};
    params.isotropic = Isotropic::Off;
    params.roi = roi;
  }
  const auto& image = work.run.source.image;
  if (leavesAlone(params, image->geometry)) return image;
  return shared(preprocess(*image, params, work.progress));
}

StepValue vesselnessStep(StepWork& work) {
  return shared(computeVesselness(*work.run.preprocessed, work.params().vesselness, work.progress));
}

StepValue seedsStep(StepWork& work) {
  return shared(
      computeSeeds(*work.run.preprocessed, *work.run.vesselness, work.params(), work.progress));
}

StepValue evolveStep(StepWork& work) {
  RunResult& run = work.run;
  if (isSegmented(run.params))
    return shared(takeLabel(*run.preprocessed, run.params, work.progress, work.warnings));
  auto vessels = work.options.keepResults ? run.vesselness : std::exchange(run.vesselness, nullptr);
  const double c = vessels->c;
  EvolveResult made = makeSegmentation(*run.preprocessed, std::move(vessels), *run.seeds,
                                       run.params, work.options, work.progress, work.warnings);
  const std::vector<std::string> doubts =
      segmentationDoubts(*run.source.image, made, run.params, c);
  work.warnings.insert(work.warnings.begin(), doubts.begin(), doubts.end());
  return shared(std::move(made));
}

/// The segmentation with the longest beginning of the corrections that is remembered; else that of
/// the evolution.
std::shared_ptr<const EvolveResult> correctedBefore(StepWork& work) {
  Parameters fewer = work.params();
  std::vector<std::string>& texts = fewer.segmentation.corrections;
  for (texts.pop_back(); !texts.empty(); texts.pop_back()) {
    const StepValue known = work.remembered(Step::Correct, fewer);
    if (const auto* result = std::get_if<std::shared_ptr<const EvolveResult>>(&known))
      return *result;
  }
  return work.run.evolve;
}

StepValue correctStep(StepWork& work) {
  const RunResult& run = work.run;
  const std::vector<std::string>& texts = run.params.segmentation.corrections;
  if (texts.empty()) return run.evolve;
  const auto start = correctedBefore(work);
  EvolveResult made = *start;
  CorrectionGround ground;
  if (!isSegmented(run.params)) ground.image = run.preprocessed.get();
  ground.vesselness = run.params.vesselness;
  const auto done = static_cast<std::ptrdiff_t>(start->corrections.size());
  Volume<float> phi = *start->phi;
  for (CorrectionOutcome& outcome :
       replay(phi, {texts.begin() + done, texts.end()}, ground, work.progress))
    made.corrections.push_back(std::move(outcome));
  if (start->voxelwise) {
    Volume<float> voxelwise = *start->voxelwise;
    carryOver(*start->phi, phi, voxelwise);
    made.voxelwise = std::make_shared<const Volume<float>>(std::move(voxelwise));
  }
  made.phi = std::make_shared<const Volume<float>>(std::move(phi));
  work.warnings = warningsOf(made.corrections);
  return shared(std::move(made));
}

StepValue surfaceStep(StepWork& work) {
  return shared(surfaceOf(*work.run.corrected, work.params(), work.progress, work.warnings,
                          [&work](const std::string& text) {
                            if (work.options.warned) work.options.warned(Step::Surface, text);
                          }));
}

/// Names are no part of the remembered surface: to change one makes nothing anew.
void namePortsOf(RunResult& run) {
  run.ports = run.surface->ports;
  std::vector<std::string>& warnings = run.stages.back().warnings;
  for (std::string& warning : namePorts(run.params.ports, run.ports))
    warnings.push_back(std::move(warning));
  for (std::string& warning : slantWarnings(run.ports)) warnings.push_back(std::move(warning));
}

StepValue smoothStep(StepWork& work) {
  const SurfaceResult& surface = *work.run.surface;
  if (work.params().smooth.method == SmoothMethod::None) return surface.mesh;
  std::size_t left = 0;
  TriMesh smoothed = smoothSurface(*surface.mesh, work.params().smooth, &work.wall(), work.progress,
                                   surface.ports, &left);
  if (left > 0) work.warnings.push_back(leftUnsmoothed(left));
  return shared(std::move(smoothed));
}

void measurePortsOf(RunResult& run) {
  if (run.smoothed != run.surface->mesh)
    for (std::string& fault : portFaults(run.ports, *run.smoothed))
      run.stages.back().warnings.push_back(std::move(fault));
  run.ports = measuredPorts(run.ports, *run.smoothed);
}

StepValue qualityStep(StepWork& work) {
  const RunResult& run = work.run;
  const SurfaceResult& surface = *run.surface;
  const Progress& progress = work.progress;
  const SplineField& field = work.wall();
  QualityResult result;
  // Marching cubes follows phi with the edges that cuts made in it.
  std::optional<SplineField> ended;
  if (surface.phi != surface.uncutPhi) ended = wallField(*surface.phi, run.params.surface.spline);
  result.marchingCubes =
      measureQuality(*surface.marchingCubes, ended ? &*ended : &field, progress.sub(0.0, 0.33));
  // Its maker has looked for triangles that meet, and smoothing lets none come to meet.
  const SurfaceOrigin& origin = surface.origin;
  const bool meetsNothing = origin.method != SurfaceMethod::MarchingCubes && origin.fault().empty();
  result.unsmoothed =
      surface.mesh == surface.marchingCubes
          ? result.marchingCubes
          : measureQuality(*surface.mesh, &field, progress.sub(0.33, 0.66), meetsNothing);
  result.unsmoothed.fromFrontPercent = origin.fromFrontPercent;
  result.mesh = run.smoothed == surface.mesh
                    ? result.unsmoothed
                    : measureQuality(*run.smoothed, &field, progress.sub(0.66, 1.0), meetsNothing);
  // Smoothing moves vertices and flips edges; it makes no triangle.
  result.mesh.fromFrontPercent = origin.fromFrontPercent;
  std::string fault = surfaceFault(*run.smoothed, run.params.surface.border == SurfaceBorder::Cap,
                                   &result.mesh, progress);
  if (!fault.empty()) work.warnings.push_back(std::move(fault));
  return shared(std::move(result));
}

template <auto member>
void store(RunResult& run, const StepValue& value) {
  auto& result = run.*member;
  result = std::get<std::remove_reference_t<decltype(result)>>(value);
}

}  // namespace

const SplineField& StepWork::wall() {
  if (!wallOnce) wallOnce.emplace(wallField(*run.surface->uncutPhi, run.params.surface.spline));
  return *wallOnce;
}

const std::vector<StepRow>& stepTable() {
  static const std::vector<StepRow> table{
      {Step::Preprocess, preprocessStep, store<&RunResult::preprocessed>},
      {Step::Vesselness, vesselnessStep, store<&RunResult::vesselness>},
      {Step::Seeds, seedsStep, store<&RunResult::seeds>},
      {Step::Evolve, evolveStep, store<&RunResult::evolve>},
      {Step::Correct, correctStep, store<&RunResult::corrected>},
      {Step::Surface, surfaceStep, store<&RunResult::surface>, namePortsOf},
      {Step::Smooth, smoothStep, store<&RunResult::smoothed>, measurePortsOf},
      {Step::Quality, qualityStep, store<&RunResult::quality>},
  };
  return table;
}

}  // namespace angiomesh

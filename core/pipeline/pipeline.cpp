// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/pipeline.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <list>
#include <new>
#include <utility>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cuts/border_slant.h"
#include "core/field/wall_field.h"
#include "core/pipeline/evolve_step.h"
#include "core/pipeline/expected_surface.h"
#include "core/pipeline/segmentation_doubts.h"
#include "core/pipeline/segments.h"
#include "core/quality/mesh_quality.h"
#include "core/vesselness/thickest.h"

namespace angiomesh {
namespace {

constexpr std::array<const char*, kStepCount> kStepIds{
    "load", "preprocess", "vesselness", "seeds", "evolve", "surface", "smooth", "quality"};

/// Raised whenever a step computes something else from the same inputs.
constexpr std::array<int, kStepCount> kStepVersions{1, 2, 2, 2, 9, 6, 4, 3};

/// Prefixes of the parameters that each step reads.
const std::array<std::vector<std::string_view>, kStepCount> kStepParams{
    {{},
     {"preprocess."},
     {"vesselness."},
     {"seeds."},
     {"segmentation.method", "levelset.", "wall.", "comparison."},
     {"segmentation.keep", "segmentation.minVolumeMm3", "segmentation.drop", "ports.cut",
      "surface."},
     {"smooth."},
     {}}};

/// The same where the image is a segmentation.
const std::array<std::vector<std::string_view>, kStepCount> kLabelParams{
    {{},
     {"segmentation.method", "preprocess.roi"},
     {},
     {"seeds.points"},  // for segmentation.keep
     {"segmentation.label", "segmentation.connectivity", "wall."},
     kStepParams[static_cast<std::size_t>(Step::Surface)],
     kStepParams[static_cast<std::size_t>(Step::Smooth)],
     {}}};

constexpr const char* kNoMemory =
    "not enough memory, surface: draw a smaller region of interest, or ask for longer edges "
    "(surface.edgeMinMm)";

std::string hex(std::uint64_t hash) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

VesselnessResult computeVesselness(const Volume<float>& image, const VesselnessParams& params,
                                   const Progress& progress) {
  VesselnessResult result;
  VesselnessParams fixed = withScalesFromImage(params, image);
  result.scalesMm = scalesMm(fixed, image.geometry);
  result.c = contrastC(params, image);
  if (!(result.c > 0.0))
    throw InputError("the image has no contrast", "vesselness.c", "give vesselness.c by hand");
  fixed.c = result.c;
  fixed.sigmaMinMm = result.scalesMm.front();
  result.multiScale = std::make_shared<const Volume<float>>(vesselness(image, fixed, progress));
  return result;
}

/// The automatic ones from the vesselness at the middle scale, which nothing else needs.
SeedsResult computeSeeds(const Volume<float>& image, const VesselnessResult& vessels,
                         const Parameters& params, const Progress& progress) {
  if (!params.seeds.automatic) return {findSeeds(Volume<float>(image.geometry), params.seeds)};
  VesselnessParams fixed = params.vesselness;
  fixed.sigmaMinMm = vessels.scalesMm.front();
  const double average = 0.5 * (vessels.scalesMm.front() + vessels.scalesMm.back());
  return {findSeeds(vesselnessAtScale(image, average, fixed, vessels.c, progress), params.seeds)};
}

SurfaceResult surface(const EvolveResult& evolved, const Parameters& params,
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

/// Names are no part of the remembered surface: to change one makes nothing anew.
void namePortsOf(RunResult& run) {
  run.ports = run.surface->ports;
  std::vector<std::string>& warnings = run.stages.back().warnings;
  for (std::string& warning : namePorts(run.params.ports, run.ports))
    warnings.push_back(std::move(warning));
  for (std::string& warning : slantWarnings(run.ports)) warnings.push_back(std::move(warning));
}

QualityResult measure(const RunResult& run, const SplineField& field, const Progress& progress) {
  QualityResult result;
  // Marching cubes follows phi with the edges that cuts made in it.
  std::optional<SplineField> ended;
  if (run.surface->phi != run.surface->uncutPhi)
    ended = wallField(*run.surface->phi, run.params.surface.spline);
  result.marchingCubes = measureQuality(*run.surface->marchingCubes, ended ? &*ended : &field,
                                        progress.sub(0.0, 0.33));
  // Its maker has looked for triangles that meet, and smoothing lets none come to meet.
  const SurfaceOrigin& origin = run.surface->origin;
  const bool meetsNothing = origin.method != SurfaceMethod::MarchingCubes && origin.fault().empty();
  result.unsmoothed =
      run.surface->mesh == run.surface->marchingCubes
          ? result.marchingCubes
          : measureQuality(*run.surface->mesh, &field, progress.sub(0.33, 0.66), meetsNothing);
  result.unsmoothed.fromFrontPercent = origin.fromFrontPercent;
  result.mesh = run.smoothed == run.surface->mesh
                    ? result.unsmoothed
                    : measureQuality(*run.smoothed, &field, progress.sub(0.66, 1.0), meetsNothing);
  // Smoothing moves vertices and flips edges; it makes no triangle.
  result.mesh.fromFrontPercent = origin.fromFrontPercent;
  return result;
}

/// What preprocessing may do to a segmentation.
PreprocessParams cropAlone(const PreprocessParams& params) {
  PreprocessParams alone;
  alone.isotropic = Isotropic::Off;
  alone.roi = params.roi;
  return alone;
}

/// One remembered result of a step.
struct Entry {
  std::string key;
  std::shared_ptr<const void> value;
  StageReport report;
};

}  // namespace

struct Pipeline::State {
  /// Undo and redo find their results again; more would keep too many volumes.
  static constexpr std::size_t kRemembered = 3;

  Source source;
  mutable std::mutex mutex;
  std::array<std::list<Entry>, kStepCount> results;  ///< most recent first
  bool keep = true;                                  ///< RunOptions::keepResults of this run

  const Entry* find(Step step, const std::string& key) {
    auto& list = results[static_cast<std::size_t>(step)];
    const auto found =
        std::find_if(list.begin(), list.end(), [&key](const Entry& e) { return e.key == key; });
    if (found == list.end()) return nullptr;
    list.splice(list.begin(), list, found);
    return &list.front();
  }

  void forget(Step step, const std::string& key) {
    const std::lock_guard lock(mutex);
    results[static_cast<std::size_t>(step)].remove_if(
        [&key](const Entry& e) { return e.key == key; });
  }

  /// The remembered result, or that of `compute(warnings)`, which is then remembered. What follows
  /// from an evolution that somebody stopped by hand is neither: its key does not tell where it was
  /// stopped.
  template <class T, class F>
  std::shared_ptr<const T> obtain(Step step, const std::string& key, RunResult& run, F compute) {
    const bool byHand = run.evolve && run.evolve->stopReason == StopReason::Stopped;
    if (!byHand) {
      const std::lock_guard lock(mutex);
      if (const Entry* known = find(step, key)) {
        run.stages.push_back(known->report);
        run.stages.back().reused = true;
        return std::static_pointer_cast<const T>(known->value);
      }
    }
    StageReport report;
    report.step = step;
    report.key = key;
    const Clock::time_point start = Clock::now();
    const double cpu = cpuSeconds();
    std::shared_ptr<const T> value = compute(report.warnings);
    report.seconds = secondsSince(start);
    report.cpuSeconds = cpuSeconds() - cpu;
    run.stages.push_back(report);
    if (!byHand && keep) remember(report, value);
    return value;
  }

  void remember(const StageReport& report, std::shared_ptr<const void> value) {
    const std::lock_guard lock(mutex);
    auto& list = results[static_cast<std::size_t>(report.step)];
    list.push_front({report.key, std::move(value), report});
    if (list.size() > kRemembered) list.pop_back();
  }
};

Pipeline::Pipeline(Source source) : state_(std::make_unique<State>()) {
  state_->source = std::move(source);
}

Pipeline::~Pipeline() = default;

const Source& Pipeline::source() const { return state_->source; }

std::string Pipeline::key(Step step, const Parameters& params) const {
  std::string text = state_->source.hash;
  const auto& names = isSegmented(params) ? kLabelParams : kStepParams;
  for (std::size_t s = 1; s <= static_cast<std::size_t>(step); ++s) {
    text += std::string("|") + kStepIds[s] + std::to_string(kStepVersions[s]);
    for (const Field& field : parameterFields())
      for (const std::string_view prefix : names[s])
        if (field.key.starts_with(prefix))
          text += ";" + field.key + "=" + fieldText(field.get(params), field);
  }
  return hex(XXH3_64bits(text.data(), text.size()));
}

bool Pipeline::has(Step step, const Parameters& params) const {
  if (step == Step::Load) return true;
  const std::string wanted = key(step, params);
  const std::lock_guard lock(state_->mutex);
  return state_->find(step, wanted) != nullptr;
}

bool Pipeline::restore(std::shared_ptr<const EvolveResult> evolve, const StageReport& report,
                       const Parameters& params) {
  if (report.step != Step::Evolve || report.key != key(Step::Evolve, params)) return false;
  state_->remember(report, std::move(evolve));
  return true;
}

RunResult Pipeline::run(const Parameters& params, const RunOptions& options,
                        const Progress& progress) {
  validate(params);
  const Clock::time_point start = Clock::now();
  const double cpu = cpuSeconds();
  state_->keep = options.keepResults;
  RunResult run;
  run.params = params;
  run.source = state_->source;
  run.key = state_->source.hash;
  Step reached = Step::Load;
  const auto wanted = [&](Step step) {
    progress.check();
    if (step > options.until) return false;
    reached = step;
    run.key = key(step, params);
    progress.phase(stepId(step));
    return true;
  };
  const auto finished = [&]() -> RunResult&& {
    progress.report(1.0);
    run.totalSeconds = secondsSince(start);
    run.cpuSeconds = cpuSeconds() - cpu;
    return std::move(run);
  };
  using Warnings = std::vector<std::string>;

  if (!wanted(Step::Preprocess)) return finished();
  run.preprocessed = state_->obtain<Volume<float>>(Step::Preprocess, run.key, run, [&](Warnings&) {
    const PreprocessParams prepared =
        isSegmented(params) ? cropAlone(params.preprocess) : params.preprocess;
    if (leavesAlone(prepared, run.source.image->geometry)) return run.source.image;
    return std::make_shared<const Volume<float>>(
        preprocess(*run.source.image, prepared, progress.sub(0.0, 0.05)));
  });
  // With the evolution's result at hand nothing needs what only it depends on.
  const bool evolved = options.until >= Step::Evolve && has(Step::Evolve, params);
  const auto needed = [&](Step step) {
    return !isSegmented(params) && (!evolved || has(step, params));
  };
  if (!wanted(Step::Vesselness)) return finished();
  if (needed(Step::Vesselness))
    run.vesselness =
        state_->obtain<VesselnessResult>(Step::Vesselness, run.key, run, [&](Warnings&) {
          return std::make_shared<const VesselnessResult>(
              computeVesselness(*run.preprocessed, params.vesselness, progress.sub(0.05, 0.32)));
        });
  if (!wanted(Step::Seeds)) return finished();
  if (needed(Step::Seeds))
    run.seeds = state_->obtain<SeedsResult>(Step::Seeds, run.key, run, [&](Warnings&) {
      return std::make_shared<const SeedsResult>(
          computeSeeds(*run.preprocessed, *run.vesselness, params, progress.sub(0.32, 0.35)));
    });
  if (!wanted(Step::Evolve)) return finished();
  const auto evolveStep = [&](Warnings& warnings) {
    if (isSegmented(params))
      return std::make_shared<const EvolveResult>(
          takeLabel(*run.preprocessed, params, progress.sub(0.35, 0.8), warnings));
    auto vessels = options.keepResults ? run.vesselness : std::exchange(run.vesselness, nullptr);
    const double c = vessels->c;
    auto made = std::make_shared<const EvolveResult>(
        makeSegmentation(*run.preprocessed, std::move(vessels), *run.seeds, params, options,
                         progress.sub(0.35, 0.79), warnings));
    const Warnings doubts = segmentationDoubts(*run.source.image, *made, params, c);
    warnings.insert(warnings.begin(), doubts.begin(), doubts.end());
    return made;
  };
  run.evolve = state_->obtain<EvolveResult>(Step::Evolve, run.key, run, evolveStep);
  if (run.evolve->stopReason == StopReason::Stopped) state_->forget(Step::Evolve, run.key);
  try {
    makeSurfaces(run, options, wanted, progress);
  } catch (const Error& error) {
    if (!options.keepOnFailure) throw;
    run.failure = {reached, error.what()};
  } catch (const std::bad_alloc&) {
    if (!options.keepOnFailure) throw;
    run.failure = {reached, kNoMemory};
  }
  if (run.failure) run.key = key(static_cast<Step>(static_cast<int>(reached) - 1), params);
  return finished();
}

void Pipeline::makeSurfaces(RunResult& run, const RunOptions& options,
                            const std::function<bool(Step)>& wanted, const Progress& progress) {
  using Warnings = std::vector<std::string>;
  const Parameters& params = run.params;
  if (!wanted(Step::Surface)) return;
  run.surface = state_->obtain<SurfaceResult>(Step::Surface, run.key, run, [&](Warnings& warnings) {
    return std::make_shared<const SurfaceResult>(surface(
        *run.evolve, params, progress.sub(0.8, 0.88), warnings, [&](const std::string& text) {
          if (options.warned) options.warned(Step::Surface, text);
        }));
  });
  namePortsOf(run);
  if (!wanted(Step::Smooth)) return;
  const SplineField field = wallField(*run.surface->uncutPhi, params.surface.spline);
  run.smoothed = state_->obtain<TriMesh>(Step::Smooth, run.key, run, [&](Warnings& warnings) {
    if (params.smooth.method == SmoothMethod::None) return run.surface->mesh;
    std::size_t left = 0;
    auto smoothed = std::make_shared<const TriMesh>(smoothSurface(*run.surface->mesh, params.smooth,
                                                                  &field, progress.sub(0.88, 0.94),
                                                                  run.surface->ports, &left));
    if (left > 0) warnings.push_back(leftUnsmoothed(left));
    return smoothed;
  });
  if (run.smoothed != run.surface->mesh)
    for (std::string& fault : portFaults(run.ports, *run.smoothed))
      run.stages.back().warnings.push_back(std::move(fault));
  run.ports = measuredPorts(run.ports, *run.smoothed);
  if (!wanted(Step::Quality)) return;
  run.quality = state_->obtain<QualityResult>(Step::Quality, run.key, run, [&](Warnings& warnings) {
    auto quality =
        std::make_shared<const QualityResult>(measure(run, field, progress.sub(0.94, 1.0)));
    std::string fault = surfaceFault(*run.smoothed, params.surface.border == SurfaceBorder::Cap,
                                     &quality->mesh, progress);
    if (!fault.empty()) warnings.push_back(std::move(fault));
    return quality;
  });
}

const char* stepId(Step step) { return kStepIds[static_cast<std::size_t>(step)]; }

std::optional<Step> stepFromId(std::string_view id) {
  for (std::size_t s = 0; s < kStepIds.size(); ++s)
    if (id == kStepIds[s]) return static_cast<Step>(s);
  return std::nullopt;
}

std::string contentHash(const Volume<float>& image) {
  const Geometry& g = image.geometry;
  std::vector<double> shape(g.size.begin(), g.size.end());
  for (int a = 0; a < 3; ++a) {
    shape.push_back(g.spacing[a]);
    shape.push_back(g.origin[a]);
    for (int b = 0; b < 3; ++b) shape.push_back(g.direction(a, b));
  }
  const std::uint64_t seed = XXH3_64bits(shape.data(), shape.size() * sizeof(double));
  return hex(XXH3_64bits_withSeed(image.voxels.data(), image.voxels.size() * sizeof(float), seed));
}

Source makeSource(Volume<float> image, const std::string& name) {
  Source source;
  source.hash = contentHash(image);
  source.image = std::make_shared<const Volume<float>>(std::move(image));
  source.name = name;
  return source;
}

Thresholds thresholdsFor(const VesselnessResult& vessels, const LevelSetParams& params) {
  return thresholds(*vessels.multiScale, params.bRule, params.xi,
                    vessels.scalesMm.back() / vessels.scalesMm.front(), params.b, params.bMin,
                    params.bMax);
}

Volume<float> speedVolume(const Volume<float>& vesselness, const Thresholds& thresholds) {
  Volume<float> out(vesselness.geometry);
  parallelFor(0, out.voxels.size(), 1 << 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      out.voxels[i] =
          static_cast<float>(vesselSpeed(static_cast<double>(vesselness.voxels[i]), thresholds));
  });
  return out;
}

}  // namespace angiomesh

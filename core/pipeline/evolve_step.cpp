// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/evolve_step.h"

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/distance/mask_distance.h"
#include "core/distance/redistance.h"
#include "core/levelset/comparison_methods.h"
#include "core/levelset/flood.h"
#include "core/pipeline/live_snapshots.h"
#include "core/pipeline/segments.h"
#include "core/pipeline/vesselness_step.h"
#include "core/pipeline/wall_step.h"

namespace angiomesh {
namespace {

constexpr int kIterationsAtOnce = 5;

/// Which part of its iterations an evolution has behind it: its change falls about as a power of
/// the iterations.
class HowFar {
 public:
  explicit HowFar(const LevelSetParams& params)
      : params_(params), total_(kUsualChecks * params.checkEvery) {}

  double at(const LevelSetEvolution& evolution) {
    const int iterations = evolution.iterations();
    const double change = evolution.change();
    if (change > 0.0 && change != change_) {
      if (change < change_ && change > params_.tolerance) {
        const double checks =
            portableLog(params_.tolerance / change) / portableLog(change / change_);
        total_ = iterations + checks * params_.checkEvery;
      }
      change_ = change;
    }
    const double most =
        std::min(params_.maxIterations, params_.stopAfter.value_or(params_.maxIterations));
    const double total = std::min(std::max(total_, iterations + 1.0), std::max(most, 1.0));
    return std::min(iterations / total, 1.0);
  }

 private:
  static constexpr int kUsualChecks = 4;

  const LevelSetParams& params_;
  double total_;
  double change_ = -1.0;
};

/// Steps the evolution to its end, obeying `options.control` and posting snapshots.
StopReason evolveWatched(LevelSetEvolution& evolution, const RunOptions& options,
                         const LevelSetParams& params, LiveSnapshots& snapshots,
                         const Progress& progress) {
  HowFar howFar(params);
  Clock::time_point shown = Clock::now() - std::chrono::hours(1);
  int posted = -1;
  int wanted = kIterationsAtOnce;
  while (!evolution.converged()) {
    snapshots.keep(evolution);
    if (options.control) {
      EvolutionControl& control = *options.control;
      if (control.finishNow) return StopReason::Stopped;
      if (control.paused) {
        const int asked = control.stepsWanted.exchange(0);
        if (asked > 0) {
          evolution.step(asked, progress);
          continue;
        }
        if (std::exchange(posted, evolution.iterations()) != evolution.iterations())
          snapshots.post(evolution);
        progress.check();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        continue;
      }
    }
    const Clock::time_point start = Clock::now();
    evolution.step(wanted, progress);
    progress.report(howFar.at(evolution));
    // Where an iteration takes long, one at a time.
    wanted = secondsSince(start) > 0.5 * options.snapshotSeconds ? 1 : kIterationsAtOnce;
    if (secondsSince(shown) < options.snapshotSeconds) continue;
    snapshots.post(evolution);
    posted = evolution.iterations();
    shown = Clock::now();
  }
  return evolution.stopReason();
}

/// The methods of segmentation.method other than our own.
EvolveResult evolveOtherwise(const Volume<float>& image, const SeedsResult& seeds,
                             const Parameters& params, const RunOptions& options,
                             const Progress& progress, std::vector<std::string>& warnings) {
  const auto stop = [&options] { return options.control && options.control->finishNow; };
  ComparisonResult found = segmentByComparison(
      image, params.segmentation.method, seeds.pointsLps, params.seeds.radiusVoxels,
      params.comparison, params.vesselness.polarity, stop, progress.sub(0.0, 0.8));
  EvolveResult result;
  result.iterations = found.iterations;
  result.stopReason = found.stopReason;
  result.converged = found.stopReason == StopReason::Converged;
  result.lower = found.lower;
  result.upper = found.upper;
  if (found.stopReason == StopReason::Limit)
    warnings.push_back("the contour ended at comparison.gac.iterations before it came to rest");
  result.phi = std::make_shared<const Volume<float>>(
      redistance(std::move(found.phi), 5.0, progress.sub(0.8, 1.0)));
  return result;
}

}  // namespace

EvolveResult makeSegmentation(const Volume<float>& image,
                              std::shared_ptr<const VesselnessResult> vessels,
                              const SeedsResult& seeds, const Parameters& params,
                              const RunOptions& options, const Progress& progress,
                              std::vector<std::string>& warnings) {
  if (params.segmentation.method != SegmentationMethod::LevelSet)
    return evolveOtherwise(image, seeds, params, options, progress, warnings);
  const LevelSetParams& p = params.levelset;
  EvolveResult result;
  result.thresholds = thresholdsFor(*vessels, params.thresholds);
  if (result.thresholds.clamped)
    warnings.push_back("b was clamped to " + std::to_string(result.thresholds.b) +
                       ": eq. 3.20 lies outside levelset.bMin to levelset.bMax on this image");
  std::shared_ptr<const Volume<float>> v = vessels->multiScale;
  vessels.reset();
  Volume<std::uint8_t> found;
  Volume<float> phi;
  LiveSnapshots snapshots(options, progress);
  const double evolved = params.lumen.enabled ? 0.3 : 0.9;  // share of the step's time
  {
    Volume<float> start;
    if (p.start == StartRule::Flood) {
      found = floodVessels(*v, result.thresholds.b, seeds.pointsLps, params.seeds.radiusVoxels,
                           static_cast<std::size_t>(p.floodLeastVoxels));
      start = floodStart(*v, result.thresholds.b, found);
    } else {
      start = fastMarchingStart(v->geometry, seeds.pointsLps, params.seeds.radiusVoxels);
    }
    LevelSetEvolution evolution(std::move(v), result.thresholds, std::move(start), p);
    result.stopReason = evolveWatched(evolution, options, p, snapshots, progress.sub(0.0, evolved));
    result.iterations = evolution.iterations();
    if (evolution.insideVoxels() == 0)
      throw NumericError("the level set shrank to nothing", "evolve",
                         "lower levelset.b or levelset.xi, or check the range of vessel sizes "
                         "(vesselness.sigmaMinMm, vesselness.sigmaMaxMm) and the seeds");
    snapshots.post(evolution);
    phi = evolution.takePhi();
  }
  result.converged = result.stopReason == StopReason::Converged;
  // Where the wall is placed anew, a front that flickers about it to the end does no harm.
  if (result.stopReason == StopReason::Limit && !params.lumen.enabled)
    warnings.push_back("the evolution ended at levelset.maxIterations before it converged");
  const Progress rest = progress.sub(evolved, 1.0);
  if (!params.lumen.enabled) {
    result.phi = std::make_shared<const Volume<float>>(redistance(std::move(phi), 5.0, rest));
    return result;
  }
  // What the evolution lost of a thin vessel was one all the same, unless somebody stopped it.
  if (found.voxels.empty() || result.stopReason == StopReason::Stopped)
    found = insideMask(phi);
  else
    for (std::size_t i = 0; i < found.voxels.size(); ++i)
      if (phi.voxels[i] < 0.0F && found.voxels[i] == 0) found.voxels[i] = 1;
  phi = {};
  releaseFreedMemory();
  WallEvidence evidence;
  WallEvidence* const told = params.wall.enabled ? &evidence : nullptr;
  phi =
      refineLumen(image, found, params.lumen, params.vesselness.polarity, rest.sub(0.0, 0.4), told);
  found = {};
  releaseFreedMemory();
  phi = redistance(std::move(phi), 5.0, rest.sub(0.4, 0.6));
  placeWall(std::move(phi), told, params.wall, result, warnings, rest.sub(0.6, 1.0));
  return result;
}

EvolveResult takeLabel(const Volume<float>& image, const Parameters& params,
                       const Progress& progress, std::vector<std::string>& warnings) {
  const auto label = static_cast<float>(params.segmentation.label);
  Volume<std::uint8_t> mask(image.geometry);
  std::size_t voxels = 0, rounded = 0;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    // As resampling and scaling leave labels: 0.988, 1.0000001.
    const float nearest = std::floor(image.voxels[i] + 0.5F);
    rounded += nearest != image.voxels[i] ? 1 : 0;
    mask.voxels[i] = nearest == label ? 1 : 0;
    voxels += mask.voxels[i];
  }
  if (rounded > 0)
    warnings.push_back(std::to_string(rounded) +
                       " voxels of the label image are no whole numbers: they were rounded");
  if (voxels == 0 || voxels == mask.voxels.size())
    throw InputError(voxels == 0 ? "no voxel has this value" : "all voxels have this value",
                     "segmentation.label = " + std::to_string(params.segmentation.label),
                     "choose another label, or another segmentation.method for a scan");
  if (const double share = shareOfBorder(mask); share > kInsideOut)
    warnings.push_back("the label lies on " + std::to_string(std::lround(100.0 * share)) +
                       " % of the volume's border, where vessels are not: is it what lies around "
                       "them? Choose another segmentation.label");
  MaskDistance made = distanceOfMask(mask, progress.sub(0.0, 0.6));
  EvolveResult result;
  result.label = {voxels, made.largestShiftVoxels, made.maskVolumeMm3, {}};
  result.converged = true;
  result.stopReason = StopReason::Converged;
  placeWall(std::move(made.phi), nullptr, params.wall, result, warnings, progress.sub(0.6, 0.9));
  Volume<float> phi = *result.phi;
  result.label->contacts =
      settleContacts(phi, mask, params.segmentation.connectivity, progress.sub(0.9, 1.0));
  result.phi = std::make_shared<const Volume<float>>(std::move(phi));
  if (const std::string words = contactText(result.label->contacts); !words.empty())
    warnings.push_back(words);
  return result;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "app/study/study_panel.h"
#include "core/base/error.h"
#include "core/image/voxels.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/segmentation_mask.h"
#include "core/pipeline/segments.h"
#include "core/quality/best_threshold.h"
#include "core/quality/overlap.h"
#include "core/quality/vessel_measures.h"

namespace angiomesh::cli {
namespace {

using Eigen::Vector3d;

constexpr double kRegionVoxels = 1.5;  // around the true walls: the vessels' region
constexpr double kOutsideVoxels =
    1.0;  // beyond the true walls: no wall is so wrong, a false vessel
constexpr double kBiasReachVoxels = 2.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Segmented {
  std::shared_ptr<const Volume<float>> phi;     ///< of the kept components
  std::shared_ptr<const Volume<float>> seeded;  ///< of those that hold a seed by hand
  double seconds = 0.0;
  RunResult run;  ///< up to the evolution

  [[nodiscard]] Volume<std::uint8_t> mask(const Volume<float>& which, const Geometry& grid) const {
    return segmentationMask(run, which, grid);
  }
};

Segmented segment(const Phantom& phantom, Parameters params, const Progress& progress) {
  const bool clutter = !phantom.pieces.empty();
  if (clutter) {
    const CentreLineSegment& root = phantom.centreLines.front();
    const Vector3d middle = 0.5 * (root.from + root.to);
    params.seeds.points.insert(params.seeds.points.end(), middle.data(), middle.data() + 3);
  }
  Segmented out;
  std::shared_ptr<const Volume<float>> evolved;
  {
    Pipeline pipeline(makeSource(phantom.image, "phantom"));
    RunOptions options;
    options.until = Step::Evolve;
    options.keepResults = false;
    out.run = pipeline.run(params, options, progress);
    out.run.preprocessed = nullptr;
    evolved = out.run.evolve->phi;
    out.seconds = out.run.totalSeconds;
  }
  const auto kept = [&](const SegmentationParams& which) {
    return withoutDropped(
        evolved, selectSegments(*evolved, which, params.seeds.points, progress.sub(0.0, 0.0)),
        progress);
  };
  out.phi = kept(params.segmentation);
  if (clutter) {
    params.segmentation.keep = KeepComponents::Seeded;
    out.seeded = kept(params.segmentation);
  }
  return out;
}

/// The truth's grid, 1 in the vessels' region: near a true wall or inside, and no clutter.
Volume<std::uint8_t> vesselRegion(const Phantom& phantom, const Volume<float>& field) {
  Volume<std::uint8_t> region(field.geometry);
  const double reach = kRegionVoxels * field.geometry.voxelMm();
  for (std::size_t i = 0; i < region.voxels.size(); ++i)
    region.voxels[i] = field.voxels[i] <= reach && phantom.clutter.voxels[i] == 0 ? 1 : 0;
  return region;
}

Volume<std::uint8_t> within(Volume<std::uint8_t> mask, const Volume<std::uint8_t>& region) {
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    mask.voxels[i] = mask.voxels[i] != 0 && region.voxels[i] != 0 ? 1 : 0;
  return mask;
}

/// Percent of the result's voxels that lie outside of the true vessels.
double outsidePercent(const Volume<std::uint8_t>& mask, const Volume<float>& field) {
  const double limit = kOutsideVoxels * field.geometry.voxelMm();
  double all = 0.0;
  double outside = 0.0;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    if (mask.voxels[i] == 0) continue;
    all += 1.0;
    if (static_cast<double>(field.voxels[i]) > limit) outside += 1.0;
  }
  return all > 0.0 ? 100.0 * outside / all : 0.0;
}

void measureMask(Measures& m, const Volume<std::uint8_t>& mask, const Volume<std::uint8_t>& truth) {
  double both = 0.0;
  double found = 0.0;
  double real = 0.0;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    found += mask.voxels[i] != 0 ? 1.0 : 0.0;
    real += truth.voxels[i] != 0 ? 1.0 : 0.0;
    both += mask.voxels[i] != 0 && truth.voxels[i] != 0 ? 1.0 : 0.0;
  }
  at(m, Metric::Overlap) = 100.0 * 2.0 * both / (found + real);
  at(m, Metric::Sensitivity) = real > 0.0 ? both / real : kNone;
  at(m, Metric::Precision) = found > 0.0 ? both / found : kNone;
}

/// The wall's place, against the exact one; within the region where there is one.
void measureWall(Measures& m, const Volume<float>& phi, const PhantomParams& params,
                 const Phantom& phantom, const Volume<std::uint8_t>* region,
                 const Progress& progress) {
  const Geometry& g = phantom.image.geometry;
  const double voxel = g.voxelMm();
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  std::vector<WallSample> samples =
      wallSamples(field, phantomDistance(params), phantom.centreLines, progress);
  if (region != nullptr)
    std::erase_if(samples, [&](const WallSample& s) {
      const Index3 near = nearestVoxel(g, s.point);
      return !g.contains(near[0], near[1], near[2]) || region->at(near[0], near[1], near[2]) == 0;
    });
  const WallDistance distance = wallDistance(samples);
  at(m, Metric::MeanDistance) = distance.meanMm / voxel;
  at(m, Metric::Distance95) = distance.percentile95Mm / voxel;
  const auto bias = [&](double from, double to) {
    return wallBias(samples, from * voxel, to * voxel, kBiasReachVoxels * voxel) / voxel;
  };
  at(m, Metric::BiasThin) = bias(1.0, 2.0);
  at(m, Metric::BiasSmall) = bias(2.0, 4.0);
  at(m, Metric::BiasMiddle) = bias(4.0, 5.0);
  at(m, Metric::BiasThick) = bias(5.0, 1e6);
  if (params.kind == PhantomKind::Tube) {
    const CentreLineSegment& line = phantom.centreLines.front();
    const double around = 2.0 * line.radiusToMm + 4.0 * voxel;
    const double radius = tubeRadius(field, line.from, line.to, around) / voxel;
    at(m, Metric::RadiusBias) = radius - params.radius;
    PhantomParams clean = params;
    clean.noiseSigma = 0.0;
    Volume<float> fullness = makePhantom(clean).image;
    const bool counted = params.psf.kind == PointSpread::Kind::Subvoxels;
    for (float& v : fullness.voxels) v = counted && v < 255.0F ? v / 256.0F : v / 255.0F;
    at(m, Metric::RadiusBiasImage) =
        radius - tubeRadiusOfShares(fullness, line.from, line.to, around) / voxel;
  }
}

/// A run without the clutter, to see what the clutter costs.
double overlapWithoutClutter(PhantomParams params, const Parameters& settings,
                             const Volume<std::uint8_t>& region, const Volume<std::uint8_t>& truth,
                             const Progress& progress) {
  params.clutter = false;
  const Segmented plain = segment(makePhantom(params), settings, progress);
  Measures m;
  m.fill(kNone);
  measureMask(m, within(plain.mask(*plain.phi, truth.geometry), region), truth);
  return at(m, Metric::Overlap);
}

/// What of the result is voxels of each kind of clutter, percent.
void measureClutter(CaseResult& out, std::size_t column, const Volume<std::uint8_t>& mask,
                    const Phantom& phantom) {
  std::array<double, 256> counts{};
  double all = 0.0;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    if (mask.voxels[i] == 0) continue;
    all += 1.0;
    counts[phantom.clutter.voxels[i]] += 1.0;
  }
  for (const ClutterPiece& piece : phantom.pieces)
    if (piece.label > 0 && all > 0.0)
      out.clutterPercent[piece.kind][column] = 100.0 * counts[piece.label] / all;
}

/// The truth and, of a tube, every voxel whose centre lies inside: a thin one that runs between
/// voxel centres fills none by half.
Volume<std::uint8_t> vesselVoxels(const PhantomParams& params, const Phantom& phantom) {
  Volume<std::uint8_t> vessel = phantom.truth;
  if (params.kind != PhantomKind::Tube) return vessel;
  const Volume<float> field = phantomField(params);
  for (std::size_t i = 0; i < vessel.voxels.size(); ++i)
    if (field.voxels[i] < 0.0F) vessel.voxels[i] = 1;
  return vessel;
}

void measureAll(CaseResult& out, const PanelCase& what, const Parameters& settings,
                const Progress& progress) {
  Measures& m = out.measures;
  const Phantom phantom = makePhantom(what.phantom, progress.sub(0.0, 0.05));
  const Segmented result = segment(phantom, settings, progress.sub(0.05, 0.5));
  at(m, Metric::Seconds) = result.seconds;
  const Progress rest = progress.sub(0.5, 1.0);
  const Geometry& g = phantom.truth.geometry;
  Volume<std::uint8_t> mask = result.mask(*result.phi, g);
  const ComponentMeasures parts =
      measureComponents(mask, vesselVoxels(what.phantom, phantom), phantom.centreLines);
  at(m, Metric::Components) = static_cast<double>(parts.components);
  at(m, Metric::FalseOnes) = static_cast<double>(parts.falseOnes);
  at(m, Metric::LargestFalse) = static_cast<double>(parts.largestFalse);
  if (what.phantom.kind == PhantomKind::Kissing) {
    const bool inTruth =
        measureComponents(phantom.truth, phantom.truth, phantom.centreLines).mergedVessels > 0;
    const auto merged = static_cast<double>(parts.mergedVessels);
    at(m, Metric::Merged) = inTruth ? 0.0 : merged;
    at(m, Metric::MergedAsTruth) = inTruth ? merged : 0.0;
  }
  at(m, Metric::RecallAll) = 100.0 * centreLineRecall(*result.phi, phantom.centreLines, 0.0);
  at(m, Metric::Recall) = 100.0 * centreLineRecall(*result.phi, phantom.centreLines, g.voxelMm());
  std::optional<Volume<std::uint8_t>> region;
  if (what.phantom.clutter) {
    const Volume<float> field = phantomField(what.phantom);
    region = vesselRegion(phantom, field);
    at(m, Metric::Outside) = outsidePercent(mask, field);
    measureClutter(out, 0, mask, phantom);
    const Volume<std::uint8_t> seeded = result.mask(*result.seeded, g);
    at(m, Metric::OutsideSeeded) = outsidePercent(seeded, field);
    measureClutter(out, 1, seeded, phantom);
    mask = within(std::move(mask), *region);
  }
  measureMask(m, mask, phantom.truth);
  if (what.phantom.kind == PhantomKind::Tree && what.phantom.noiseSigma > 0.0 && !region)
    at(m, Metric::BestThreshold) = bestThreshold(phantom.image, phantom.truth).overlap;
  measureWall(m, *result.phi, what.phantom, phantom, region ? &*region : nullptr, rest);
  if (region)
    at(m, Metric::OverlapLoss) =
        overlapWithoutClutter(what.phantom, settings, *region, phantom.truth, rest) -
        at(m, Metric::Overlap);
}

}  // namespace

CaseResult runCase(const PanelCase& what, const Parameters& params, const Progress& progress) {
  CaseResult result;
  result.name = what.name;
  result.measures.fill(kNone);
  try {
    measureAll(result, what, params, progress);
  } catch (const NumericError& error) {  // the pipeline found no vessel at all
    result.failure = error.what();
    result.measures.fill(kNone);
    at(result.measures, Metric::Overlap) = 0.0;
    at(result.measures, Metric::Sensitivity) = 0.0;
    at(result.measures, Metric::Recall) = 0.0;
    at(result.measures, Metric::RecallAll) = 0.0;
  }
  progress.report(1.0);
  return result;
}

}  // namespace angiomesh::cli

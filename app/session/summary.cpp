// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/summary.h"

#include "core/parameters/field.h"
#include "core/quality/quality_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

namespace angiomesh::cli {
namespace {

void printGrid(const char* label, const Geometry& g) {
  std::printf("%-13s %d x %d x %d voxels of %.4g x %.4g x %.4g mm\n", label, g.size[0], g.size[1],
              g.size[2], g.spacing.x(), g.spacing.y(), g.spacing.z());
}

const char* endOf(const EvolveResult& evolve) {
  switch (evolve.stopReason) {
    case StopReason::Converged:
      return "converged";
    case StopReason::Settled:
      return "settled";
    case StopReason::Limit:
      return "not converged: the limit was reached";
    case StopReason::Running:
    case StopReason::Stopped:
      break;
  }
  return "stopped";
}

void printComponents(const std::vector<SegmentComponent>& parts) {
  constexpr std::size_t kMost = 5;
  for (std::size_t n = 0; n < std::min(parts.size(), kMost); ++n) {
    const SegmentComponent& part = parts[n];
    std::printf("%-13s %.4g mm3", n == 0 ? "components" : "", part.volumeMm3);
    if (part.measure && part.measure->lengthMm > 0.0)
      std::printf(", length %.4g mm", part.measure->lengthMm);
    if (part.measure) std::printf(", mean radius %.3g mm", part.measure->meanRadiusMm);
    std::printf("%s%s\n", part.seeded ? ", seeded" : "", part.kept ? "" : ", left out");
  }
  if (parts.size() > kMost) std::printf("%-13s and %zu smaller ones\n", "", parts.size() - kMost);
}

void printSegmentation(const RunResult& result) {
  const EvolveResult& evolve = *result.evolve;
  std::printf("%-13s", "segmentation");
  if (result.surface) {
    const auto& parts = result.surface->components;
    std::size_t kept = 0, voxels = 0, most = 0;
    for (const SegmentComponent& part : parts) {
      if (!part.kept) continue;
      ++kept;
      voxels += part.voxels;
      most = std::max(most, part.voxels);
    }
    // Cuts may have taken some of them.
    std::printf(" %zu voxels in %zu component%s", result.surface->insideVoxels, kept,
                kept == 1 ? "" : "s");
    if (voxels > 0)
      std::printf(" (the largest: %.1f %%)",
                  100.0 * static_cast<double>(most) / static_cast<double>(voxels));
    std::printf(",");
  }
  if (evolves(result.params))
    std::printf(" %d iterations, %s", evolve.iterations, endOf(evolve));
  else
    std::printf(" no evolution");
  const std::size_t seeds = result.seeds ? result.seeds->pointsLps.size() : 0;
  if (result.params.segmentation.method == SegmentationMethod::LevelSet) {
    std::printf("\n%-13s a %.4g, b %.4g%s; %zu seeds\n", "thresholds", evolve.thresholds.a,
                evolve.thresholds.b, evolve.thresholds.clamped ? " (clamped)" : "", seeds);
    return;
  }
  const Field& method = findField("segmentation.method");
  std::printf("\n%-13s %s", "method", fieldText(method.get(result.params), method).c_str());
  if (evolve.lower) std::printf(", intensities from %.4g", *evolve.lower);
  if (evolve.upper) std::printf("%s to %.4g", evolve.lower ? "" : ", intensities", *evolve.upper);
  if (evolve.label)
    std::printf(" %d, %zu voxels, moved by at most %.2f voxel\n", result.params.segmentation.label,
                evolve.label->voxels, evolve.label->largestShiftVoxels);
  else
    std::printf("; %zu seeds\n", seeds);
}

}  // namespace

void printQualities(const std::vector<NamedQuality>& columns) {
  constexpr int kLabelWidth = 34, kColumnWidth = 16;
  std::printf("  %-*s", kLabelWidth, "");
  for (const NamedQuality& column : columns) std::printf("%*s", kColumnWidth, column.name.c_str());
  std::printf("\n");
  for (const QualityMeasure& measure : qualityMeasures()) {
    if (!measure.main || std::none_of(columns.begin(), columns.end(), [&](const NamedQuality& c) {
          return measure.value(*c.quality).has_value();
        }))
      continue;
    const std::string unit = *measure.unit != '\0' ? " (" + std::string(measure.unit) + ")" : "";
    std::printf("  %-*s", kLabelWidth, (measure.label + unit).c_str());
    for (const NamedQuality& column : columns)
      std::printf("%*s", kColumnWidth, measureText(measure, *column.quality).c_str());
    std::printf("\n");
  }
}

void printSurface(std::size_t triangles, const SurfaceOrigin& origin) {
  std::printf("%zu triangles", triangles);
  if (origin.estimatedTriangles) std::printf(" (%.0f estimated)", *origin.estimatedTriangles);
  if (origin.fromFrontPercent)
    std::printf(", %.2f %% from the advancing front", *origin.fromFrontPercent);
  if (const std::size_t count = origin.components.size(); count > 0)
    std::printf(
        ", %zu component%s, %zu verified, genus %d", count, count == 1 ? "" : "s",
        count - origin.unverified(),
        std::accumulate(origin.components.begin(), origin.components.end(), 0,
                        [](int sum, const SurfaceComponent& part) { return sum + part.genus(); }));
  std::printf("\n");
}

void printPorts(const std::vector<Port>& ports) {
  for (const Port& port : ports) {
    std::printf("%-13s %s: %.4g mm2", "port", port.name.c_str(), port.areaMm2);
    if (port.slant)
      std::printf(", %.0f degrees off the vessel's axis, %.2f times the section just inside",
                  port.slant->angleDeg, port.slant->areaRatio);
    std::printf("\n");
  }
}

void printOverlap(const OverlapMeasures& m) {
  std::printf("%-13s overlap %.2f %%, sensitivity %.4f, precision %.4f", "truth", m.overlap,
              m.sensitivity, m.precision);
  if (std::isfinite(m.assdMm) && std::isfinite(m.hd95Mm))
    std::printf(", ASSD %.3g mm, HD95 %.3g mm", m.assdMm, m.hd95Mm);
  std::printf("\n");
}

void printSummary(const RunResult& result, const std::optional<OverlapMeasures>& truth) {
  printGrid("input", result.source.image->geometry);
  if (result.preprocessed) printGrid("working grid", result.preprocessed->geometry);
  if (result.evolve) printSegmentation(result);
  if (result.surface) printComponents(result.surface->components);
  if (truth) printOverlap(*truth);
  if (result.surface) {
    std::printf("%-13s ", "surface");
    printSurface(result.surface->mesh->triangles.size(), result.surface->origin);
    printPorts(result.ports);
  }
  for (const StageReport& stage : result.stages)
    for (const std::string& warning : stage.warnings)
      std::printf("%-13s %s: %s\n", "warning", stepId(stage.step), warning.c_str());
  std::printf("%-13s", "seconds");
  for (const StageReport& stage : result.stages)
    std::printf(" %s %.2f,", stepId(stage.step), stage.seconds);
  std::printf(" total %.2f\n", result.totalSeconds);
  if (result.quality) {
    std::printf("\n");
    printQualities(
        {{"vessels", &result.quality->mesh}, {"marching cubes", &result.quality->marchingCubes}});
  }
}

}  // namespace angiomesh::cli

// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/parallel.h"
#include "core/measure/review_json.h"
#include "core/openings/port_json.h"
#include "core/parameters/field.h"
#include "core/quality/quality_json.h"

namespace angiomesh {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr int kIndent = 2;

Json gridBlock(const Geometry& geometry) {
  return {{"size", geometry.size},
          {"spacing_mm", {geometry.spacing.x(), geometry.spacing.y(), geometry.spacing.z()}}};
}

Json overlapBlock(const OverlapMeasures& m) {
  Json block{{"overlap", m.overlap}, {"sensitivity", m.sensitivity}, {"precision", m.precision}};
  // Without a voxel in the result there is no distance to it.
  if (std::isfinite(m.assdMm)) block["assd_mm"] = m.assdMm;
  if (std::isfinite(m.hd95Mm)) block["hd95_mm"] = m.hd95Mm;
  return block;
}

const char* stopReasonText(StopReason reason) {
  switch (reason) {
    case StopReason::Converged:
      return "converged";
    case StopReason::Settled:
      return "settled";
    case StopReason::Limit:
      return "limit";
    case StopReason::Running:
    case StopReason::Stopped:
      break;
  }
  return "stopped";
}

/// The largest components; those left out of the surface, too.
Json componentList(const std::vector<SegmentComponent>& components) {
  Json list = Json::array();
  for (const SegmentComponent& component : components) {
    if (list.size() == kMeasuredComponents) break;
    Json part{{"volume_mm3", component.volumeMm3}};
    if (component.measure) {
      if (component.measure->lengthMm > 0.0) part["length_mm"] = component.measure->lengthMm;
      part["mean_radius_mm"] = component.measure->meanRadiusMm;
    }
    part["seeded"] = component.seeded;
    part["kept"] = component.kept;
    list.push_back(std::move(part));
  }
  return list;
}

Json segmentationBlock(const RunResult& result) {
  const EvolveResult& evolve = *result.segmentation();
  const Field& method = findField("segmentation.method");
  Json block{{"method", fieldText(method.get(result.params), method)}};
  if (evolves(result.params)) {
    block["iterations"] = evolve.iterations;
    block["converged"] = evolve.converged;
    block["stop_reason"] = stopReasonText(evolve.stopReason);
  }
  if (result.surface) {
    std::size_t kept = 0;
    for (const SegmentComponent& component : result.surface->components) kept += component.kept;
    block["inside_voxels"] = result.surface->insideVoxels;
    block["components"] = kept;
    block["components_found"] = result.surface->components.size();
    block["component_list"] = componentList(result.surface->components);
  } else {
    const Components parts = connectedComponents(insideMask(*evolve.phi));
    std::size_t inside = 0;
    for (const std::size_t size : parts.sizes) inside += size;
    block["inside_voxels"] = inside;
    block["components"] = parts.sizes.size();
  }
  if (result.params.segmentation.method == SegmentationMethod::LevelSet)
    block["thresholds"] = {{"a", evolve.thresholds.a},
                           {"b", evolve.thresholds.b},
                           {"v_avg", evolve.thresholds.vAverage},
                           {"clamped", evolve.thresholds.clamped}};
  if (evolve.wall) {
    Json& wall = block["wall"] = {{"held_voxels", evolve.wall->heldVoxels},
                                  {"filled_holes", evolve.wall->filledHoles},
                                  {"cut_handles", evolve.wall->cutHandles}};
    if (evolve.wall->spreadVoxels > 0.0) wall["spread_voxels"] = evolve.wall->spreadVoxels;
  }
  if (evolve.label)
    block["label"] = {{"value", result.params.segmentation.label},
                      {"voxels", evolve.label->voxels},
                      {"largest_shift_voxels", evolve.label->largestShiftVoxels},
                      {"mask_volume_mm3", evolve.label->maskVolumeMm3},
                      {"contacts",
                       {{"joined", evolve.label->contacts.joined},
                        {"parted", evolve.label->contacts.parted},
                        {"left", evolve.label->contacts.left}}}};
  if (evolve.lower) block["intensity"]["lower"] = *evolve.lower;
  if (evolve.upper) block["intensity"]["upper"] = *evolve.upper;
  for (const CorrectionOutcome& outcome : evolve.corrections) {
    Json one{{"correction", outcome.text},
             {"added_voxels", outcome.added},
             {"removed_voxels", outcome.removed}};
    if (!outcome.why.empty()) one["left_out"] = outcome.why;
    block["corrections"].push_back(std::move(one));
  }
  if (result.seeds) block["seeds"] = result.seeds->pointsLps.size();
  return block;
}

/// As surface.method names it.
std::string methodId(SurfaceMethod made) {
  Parameters params;
  params.surface.method = made;
  const Field& method = findField("surface.method");
  return fieldText(method.get(params), method);
}

Json componentBlock(const SurfaceComponent& part) {
  Json block{{"triangles", part.triangles},     {"euler", part.euler},
             {"genus", part.genus()},           {"boundary_loops", part.boundaryLoops},
             {"method", methodId(part.method)}, {"verified", part.verified}};
  if (!part.instead.empty()) block["instead"] = part.instead;
  if (!part.verified) block["why"] = part.why;
  if (part.boundaryLoops == 0) block["volume_mm3"] = part.volumeMm3;
  return block;
}

/// More of them is noise.
constexpr std::size_t kNamedHandles = 200;

Json handleBlock(const Handle& handle) {
  const auto numbers = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  const char* kind = handle.kind == HandleKind::Hole   ? "hole"
                     : handle.kind == HandleKind::Thin ? "thin"
                                                       : "loop";
  return {{"kind", kind},
          {handle.lengthIsLeast ? "length_at_least_mm" : "length_mm", handle.lengthMm},
          {"centre_mm", numbers(handle.centreLps)},
          {"thinnest_mm", numbers(handle.placeLps)},
          {"depth_mm", handle.depthMm}};
}

Json surfaceBlock(const SurfaceOrigin& origin) {
  Json block{{"method", methodId(origin.method)}};
  if (origin.estimatedTriangles) block["estimated_triangles"] = *origin.estimatedTriangles;
  if (origin.smoothTriangles) block["smooth_triangles"] = *origin.smoothTriangles;
  if (origin.fromFrontPercent) block["from_front_percent"] = *origin.fromFrontPercent;
  if (!origin.components.empty()) {
    block["components"] = Json::array();
    for (const SurfaceComponent& part : origin.components) {
      block["components"].push_back(componentBlock(part));
      if (origin.fromFrontPercent)
        block["components"].back()["from_front_percent"] = part.fromFrontPercent;
    }
    block["unverified"] = origin.unverified();
    block["handles"] = origin.handles.size();
    block["handle_list"] = Json::array();
    for (std::size_t n = 0; n < std::min(origin.handles.size(), kNamedHandles); ++n)
      block["handle_list"].push_back(handleBlock(origin.handles[n]));
  }
  // An estimate alone says nothing of what will be left out.
  const bool estimateAlone = origin.estimatedTriangles && origin.components.empty();
  if (!estimateAlone || !origin.dropped.empty()) block["dropped"] = origin.dropped;
  return block;
}

/// The openings, as the last mesh of the run has them.
Json portList(const std::vector<Port>& ports, const std::vector<double>& sectionAreasMm2) {
  Json list = Json::array();
  for (std::size_t n = 0; n < ports.size(); ++n) {
    list.push_back(portJson<Json>(ports[n]));
    if (n < sectionAreasMm2.size()) list.back()["section_area_mm2"] = sectionAreasMm2[n];
  }
  return list;
}

/// What smoothing did to the size of the surface. The radius is the one of a tube of the same
/// volume and area, 2 V / A; an open surface encloses no volume.
Json smoothingBlock(const MeshQuality& before, const MeshQuality& after) {
  const auto percent = [](double from, double to) { return 100.0 * (to / from - 1.0); };
  Json block;
  block["area_change_percent"] = percent(before.areaMm2, after.areaMm2);
  if (before.hasVolume() && after.hasVolume()) {
    block["volume_change_percent"] = percent(before.volumeMm3, after.volumeMm3);
    block["radius_change_percent"] =
        percent(before.volumeMm3 / before.areaMm2, after.volumeMm3 / after.areaMm2);
  }
  return block;
}

std::optional<double> peakMemoryMb() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return std::nullopt;
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in units of 1024 bytes
}

template <class T>
void addBytes(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

}  // namespace

const TriMesh* finalMesh(const RunResult& result) {
  if (result.smoothed) return result.smoothed.get();
  return result.surface ? result.surface->mesh.get() : nullptr;
}

std::string meshHash(const TriMesh& mesh) {
  std::string bytes;
  addBytes(bytes, mesh.points);
  addBytes(bytes, mesh.triangles);
  addBytes(bytes, mesh.patch);
  return textHash(bytes);
}

std::string runReportJson(const RunResult& result, const std::optional<OverlapMeasures>& truth,
                          const CaseReview& review) {
  Json report{{"schema", kSchema},
              {"version", versionText()},
              {"key", result.key},
              {"threads", threads()},
              {"total_seconds", result.totalSeconds},
              {"cpu_seconds", result.cpuSeconds}};
  if (const auto memory = peakMemoryMb()) report["peak_rss_mb"] = *memory;
  report["parameters"] = Json::parse(parametersToJson(result.params));
  report["warnings"] = Json::array();
  for (const StageReport& stage : result.stages)
    for (const std::string& warning : stage.warnings) report["warnings"].push_back(warning);

  if (result.failure)
    report["failure"] = {{"step", stepId(result.failure->step)}, {"error", result.failure->why}};
  if (result.source.image) report["input"] = gridBlock(result.source.image->geometry);
  if (result.preprocessed) report["working"] = gridBlock(result.preprocessed->geometry);
  report["stages"] = Json::array();
  for (const StageReport& stage : result.stages)
    report["stages"].push_back({{"name", stepId(stage.step)},
                                {"seconds", stage.seconds},
                                {"cpu_seconds", stage.cpuSeconds}});

  if (result.evolve) report["segmentation"] = segmentationBlock(result);
  if (truth) report["truth"] = overlapBlock(*truth);
  if (result.surface) {
    report["mesh_hash"] = meshHash(*finalMesh(result));
    report["surface"] = surfaceBlock(result.surface->origin);
    report["ports"] = portList(result.ports, result.surface->sectionAreasMm2);
  }
  if (result.quality) {
    if (result.params.smooth.method != SmoothMethod::None &&
        result.quality->unsmoothed.areaMm2 > 0.0)
      report["smoothing"] = smoothingBlock(result.quality->unsmoothed, result.quality->mesh);
    report["mesh"] = qualityJson<Json>(result.quality->mesh);
    report["mesh_unsmoothed"] = qualityJson<Json>(result.quality->unsmoothed);
    report["marching_cubes"] = qualityJson<Json>(result.quality->marchingCubes);
  }
  if (!review.empty()) report["review"] = reviewJson<Json>(review, "place_mm");
  return report.dump(kIndent) + "\n";
}

std::string surfaceJson(const SurfaceOrigin& origin) {
  return Json{{"schema", kSchema}, {"surface", surfaceBlock(origin)}}.dump(kIndent) + "\n";
}

std::string overlapJson(const OverlapMeasures& measures) {
  return Json{{"schema", kSchema}, {"truth", overlapBlock(measures)}}.dump(kIndent) + "\n";
}

}  // namespace angiomesh

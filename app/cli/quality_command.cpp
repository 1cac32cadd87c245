// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/commands.h"
#include "app/session/field_input.h"
#include "app/session/mesh_files.h"
#include "app/session/options.h"
#include "app/session/summary.h"
#include "app/session/wall_text.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/field/spline_field.h"
#include "core/field/wall_field.h"
#include "core/parameters/field.h"
#include "core/phantom/truth_json.h"
#include "core/quality/quality_gates.h"
#include "core/quality/quality_json.h"
#include "core/quality/sizing_check.h"
#include "core/quality/zero_set_measure.h"
#include "core/sizing/guidance_field.h"
#include "io/file/files.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

const QualityGate& findGate(const std::string& name) {
  for (const QualityGate& gate : qualityGates())
    if (name == gate.name) return gate;
  throw InputError("no gate is called '" + name + "'", "--gate",
                   "use one of " + joined(qualityGates(), ", ", &QualityGate::name));
}

struct QualityOptions {
  ParameterOptions settings;
  std::string mesh, phi, spline, against, truth, gate, frame, unit;
  MaskChoice choice;
  MeshReading reading;
  bool json = false, measures = false;

  /// The interpolant of phi and the wanted edge length, by --set surface.* and --spline.
  [[nodiscard]] SurfaceParams surface() const {
    Parameters params = settings.parameters();
    if (!spline.empty()) setFieldFromText(params, "surface.spline", spline);
    return params.surface;
  }
};

/// What only a level set function can tell of a mesh.
struct WallMeasures {
  ZeroSetMeasure zeroSet;
  SizingCheck sizing;
  double estimatedTriangles = 0.0;
};

WallMeasures measureWall(const TriMesh& mesh, const SplineField& phi, const SizingParams& params,
                         const Progress& progress) {
  WallMeasures wall;
  wall.zeroSet = measureZeroSet(phi, progress.sub(0.0, 0.4));
  const GuidanceField wanted(phi, params, progress.sub(0.4, 0.8));
  wall.sizing = checkSizing(mesh, wanted, phi.geometry(), progress.sub(0.8, 1.0));
  wall.estimatedTriangles = wanted.estimatedTriangles();
  return wall;
}

Json wallBlocks(const WallMeasures& wall, const MeshQuality& mesh) {
  Json zeroSet{{"volume_mm3", wall.zeroSet.volumeMm3}, {"area_mm2", wall.zeroSet.areaMm2}};
  // An open surface encloses no volume.
  if (mesh.hasVolume() && wall.zeroSet.volumeMm3 > 0.0)
    zeroSet["volume_change_percent"] = 100.0 * (mesh.volumeMm3 / wall.zeroSet.volumeMm3 - 1.0);
  Json sizing{{"edges_in_range_percent", wall.sizing.edgesInRangePercent},
              {"edge_ratio_mean", wall.sizing.edgeRatioMean},
              {"triangles", wall.sizing.triangles},
              {"wanted_triangles", wall.sizing.wantedTriangles}};
  if (wall.sizing.wantedTriangles > 0.0)
    sizing["triangle_excess_percent"] =
        100.0 * (static_cast<double>(wall.sizing.triangles) / wall.sizing.wantedTriangles - 1.0);
  sizing["estimated_triangles"] = wall.estimatedTriangles;
  return {{"zero_set", zeroSet}, {"sizing", sizing}};
}

void printWall(const WallMeasures& wall, const MeshQuality& mesh) {
  std::printf("\nzero set      area %.6g mm2, volume %.6g mm3", wall.zeroSet.areaMm2,
              wall.zeroSet.volumeMm3);
  if (mesh.hasVolume() && wall.zeroSet.volumeMm3 > 0.0)
    std::printf(" (the mesh: %+.3f %%)", 100.0 * (mesh.volumeMm3 / wall.zeroSet.volumeMm3 - 1.0));
  std::printf(
      "\nedge length   %.2f %% of the edges within 0.7 to 1.4 of the wanted length, mean "
      "%.3f of it\n",
      wall.sizing.edgesInRangePercent, wall.sizing.edgeRatioMean);
  std::printf("triangles     %zu of the wall, %.0f wanted for its area\n", wall.sizing.triangles,
              wall.sizing.wantedTriangles);
}

/// The mesh to measure, placed as the user says.
TriMesh measuredMesh(const QualityOptions& options) {
  LoadedMesh loaded = loadMesh(options.mesh, options.reading.options(options.frame, options.unit));
  for (const std::string& warning : loaded.warnings) printWarning(warning);
  if (!options.phi.empty() && !loaded.frameStated && options.frame.empty())
    printWarning("the mesh does not say its frame, LPS is taken, " + options.mesh +
                 ": give --frame ras if it is in RAS");
  return std::move(loaded.mesh);
}

/// The other mesh: by its header, and where that is silent as the user says of the first one.
TriMesh againstMesh(const QualityOptions& options) {
  LoadedMesh loaded = loadMesh(options.against, options.reading.options());
  if (!loaded.frameStated && !loaded.unitStated)
    loaded = loadMesh(options.against, options.reading.options(options.frame, options.unit));
  for (const std::string& warning : loaded.warnings) printWarning(warning);
  return std::move(loaded.mesh);
}

int quality(const QualityOptions& options, const Progress& progress) {
  const QualityGate* gate = options.gate.empty() ? nullptr : &findGate(options.gate);
  const SurfaceParams surface = options.surface();
  std::optional<SplineField> phi;
  if (!options.phi.empty()) {
    const Parameters params = options.settings.parameters();
    const MeshInput input =
        readMeshInput(options.phi, options.choice, &params, progress.sub(0.0, 0.2));
    phi = wallField(input.phi, surface.spline);
  }
  const SplineField* field = phi ? &*phi : nullptr;
  const TriMesh mesh = measuredMesh(options);
  const MeshQuality mine = measureQuality(mesh, field, progress.sub(0.0, 0.4));
  std::optional<WallMeasures> wall;
  if (phi) wall = measureWall(mesh, *phi, surface.sizing, progress.sub(0.4, 0.7));
  std::optional<WallTruth> truth;
  if (!options.truth.empty())
    truth.emplace(phantomFromTruthJson(readText(options.truth, kMostJsonBytes), options.truth));
  std::optional<WallAccuracy> accuracy;
  if (truth) accuracy = wallAccuracy(mesh, *truth, progress.sub(0.65, 0.7));
  std::optional<MeshQuality> other;
  if (!options.against.empty())
    other = measureQuality(againstMesh(options), field, progress.sub(0.7, 1.0));
  const std::vector<std::string> failed =
      gate != nullptr ? gateFailures(*gate, mine) : std::vector<std::string>{};

  if (options.json) {
    Json report{{"schema", 1}, {"mesh", qualityJson<Json>(mine)}};
    if (wall) report.update(wallBlocks(*wall, mine));
    if (accuracy) report["wall"] = wallJson(*accuracy, truth->grid().voxelMm());
    if (other) report["against"] = qualityJson<Json>(*other);
    if (gate != nullptr)
      report["gate"] = {{"name", gate->name}, {"passed", failed.empty()}, {"failures", failed}};
    std::printf("%s\n", report.dump(2).c_str());
  } else {
    std::vector<NamedQuality> columns{{"mesh", &mine}};
    if (other) columns.push_back({"against", &*other});
    printQualities(columns);
    if (wall) printWall(*wall, mine);
    if (accuracy) printWallAccuracy(*accuracy, truth->grid().voxelMm());
  }
  if (failed.empty()) return Done;
  printError("the mesh fails the gate '" + options.gate + "' (" + joined(failed) + "), " +
             options.mesh + ": repair or remesh it");
  return GateFailed;
}

/// The page of docs.
int printMeasures() {
  std::printf(
      "# Measures of mesh quality\n\n"
      "Keys as in `report.json` (nested by the dots) and in `angiomesh-cli quality --json`; names "
      "as "
      "in\nsummaries and in the mesh inspector, which shows those in bold first. A measure that a "
      "mesh "
      "has\nnot is absent.\n\nThis page is the output of `angiomesh-cli quality --measures`.\n\n"
      "| key | name | unit | meaning |\n|---|---|---|---|\n");
  for (const QualityMeasure& measure : qualityMeasures()) {
    const char* bold = measure.main ? "**" : "";
    std::printf("| `%s` | %s%s%s | %s | %s |\n", measure.key, bold, measure.label, bold,
                measure.unit, measure.meaning);
  }
  std::printf(
      "\n## Gates\n\n`angiomesh-cli quality MESH --gate NAME` ends with exit code 3 unless "
      "the mesh passes.\n\n| gate | passes |\n|---|---|\n");
  for (const QualityGate& gate : qualityGates())
    std::printf("| `%s` | %s |\n", gate.name, gate.help);
  return Done;
}

}  // namespace

void addQuality(CLI::App& program, Session& session) {
  auto options = std::make_shared<QualityOptions>();
  CLI::App* command = program.add_subcommand("quality", "What a mesh is worth to a solver");
  command->add_option("MESH", options->mesh, "Mesh to measure");
  command->add_flag("--measures", options->measures, "Print what is measured, as docs/quality.md");
  command->add_option("--phi", options->phi,
                      "Level set function, mask or label image to measure against");
  addMaskChoice(*command, options->choice);
  command->add_option("--spline", options->spline,
                      "Interpolant of phi: interpolating-bspline, bspline or catmull-rom");
  command->add_option("--against", options->against, "Another mesh, to be measured beside it");
  command->add_option("--truth", options->truth,
                      "truth.json of the phantom that the mesh was made from: distance, normals "
                      "and curvature against its exact wall");
  command
      ->add_option("--frame", options->frame, "Of the mesh, whatever its header says: lps or ras")
      ->check(CLI::IsMember({"lps", "ras"}));
  command->add_option("--unit", options->unit, "Of the mesh, whatever its header says: mm or m")
      ->check(CLI::IsMember({"mm", "m"}));
  addMeshReading(*command, options->reading);
  std::string gates = "End with exit code 3 unless the mesh passes:";
  for (const QualityGate& gate : qualityGates())
    gates += std::string(" ") + gate.name + " (" + gate.help + ")";
  command->add_option("--gate", options->gate, gates);
  command->add_flag("--json", options->json, "Print JSON");
  addSettings(*command, options->settings);
  command->callback([options, &session] {
    session.action = [options, &session] {
      if (options->measures) return printMeasures();
      if (options->mesh.empty())
        throw InputError("no mesh is named", "MESH", "give the mesh to measure");
      return quality(*options, session.progress);
    };
  });
}

}  // namespace angiomesh::cli

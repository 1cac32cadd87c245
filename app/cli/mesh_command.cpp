// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/session/field_input.h"
#include "app/session/mesh_files.h"
#include "app/session/options.h"
#include "app/session/summary.h"
#include "core/base/error.h"
#include "core/cuts/border_slant.h"
#include "core/cuts/cuts.h"
#include "core/field/wall_field.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/tri_mesh.h"
#include "core/pipeline/expected_surface.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/report.h"
#include "core/pipeline/surface_step.h"
#include "core/quality/mesh_quality.h"
#include "core/smooth/smoothing.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_io.h"
#include "io/mesh/mesh_place.h"
#include "io/vessel/ports_file.h"

namespace angiomesh::cli {
namespace {

struct MeshOptions {
  ParameterOptions settings;
  std::string input, output;
  MaskChoice choice;
  Soundness soundness;
  bool estimate = false, json = false;
};

using Json = nlohmann::ordered_json;

bool isClosed(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t first = 0; first < sides.size();) {
    const std::size_t end = edgeRunEnd(sides, first);
    if ((end - first) % 2 != 0) return false;
    first = end;
  }
  return true;
}

/// Where the surface comes from and, of a mask, how the volumes compare.
Json sourceBlock(const MeshInput& input, const TriMesh* mesh) {
  if (input.labels.empty()) return {{"kind", "level-set"}};
  const Label& first = input.labels.front();
  Json block{{"kind", input.otherLabels ? "label" : "mask"}, {"label", first.value}};
  if (!first.name.empty()) block["name"] = first.name;
  if (input.labels.size() > 1)
    for (const Label& label : input.labels)
      block["labels"].push_back(
          {{"value", label.value}, {"name", label.name}, {"voxels", label.voxels}});
  block["voxels"] = input.voxels;
  block["largest_shift_voxels"] = input.largestShiftVoxels;
  block["mask_volume_mm3"] = input.maskVolumeMm3;
  if (mesh != nullptr && isClosed(*mesh)) {
    const double volume = enclosedVolumeMm3(*mesh);
    block["mesh_volume_mm3"] = volume;
    block["volume_change_percent"] = 100.0 * (volume / input.maskVolumeMm3 - 1.0);
  }
  return block;
}

void printJson(const SurfaceOrigin& origin, const Json& source) {
  Json report = Json::parse(surfaceJson(origin));
  report["source"] = source;
  std::printf("%s\n", report.dump(2).c_str());
}

void printSource(const Json& source) {
  if (source.at("kind") == "level-set") return;
  const auto nameOf = [](const Json& label, const char* value) {
    const std::string name = label.value("name", std::string());
    return label.at(value).dump() + (name.empty() ? "" : " '" + name + "'");
  };
  std::string name = nameOf(source, "label");
  const Json joined = source.value("labels", Json::array());
  for (std::size_t n = 1; n < joined.size(); ++n) name += ", " + nameOf(joined[n], "value");
  std::printf("label %s: %.6g mm3, moved by at most %.2f voxel", name.c_str(),
              source.at("mask_volume_mm3").get<double>(),
              source.at("largest_shift_voxels").get<double>());
  if (source.contains("volume_change_percent"))
    std::printf("; the mesh holds %+.2f %%", source.at("volume_change_percent").get<double>());
  std::printf("\n");
}

/// Half of each voxel at the border lies outside of the grid on which the wall is known.
void sayBorder(const MeshInput& input, const TriMesh& mesh, bool cut) {
  std::string text =
      "the label reaches the border of the volume, where the surface ends in the middle of the "
      "voxels";
  const Geometry& g = input.phi.geometry;
  const double whole = static_cast<double>(input.voxels) * g.spacing.prod();
  const double held = cut || !isClosed(mesh) ? 1.0 : enclosedVolumeMm3(mesh) / whole;
  if (held < 1.0)
    text += ": it holds " + std::to_string(std::lround(100.0 * held)) + " % of the label's voxels";
  printWarning(text + "; to keep all of them, add a slice of zeros there");
}

int estimate(const MeshInput& input, const SplineField& field, const CutAway& away,
             const MeshOptions& options, const SurfaceParams& params, const Json& source,
             const Progress& progress) {
  if (params.method == SurfaceMethod::MarchingCubes)
    throw InputError("marching cubes follows no size that could be estimated", "--estimate",
                     "choose surface.method advancing-front or remesh");
  const ExpectedSurface expected = expectSurface(input.phi, field, params, progress, away);
  SurfaceOrigin origin;
  origin.method = params.method;
  origin.estimatedTriangles = expected.triangles;
  origin.smoothTriangles = expected.smoothTriangles;
  if (options.json)
    printJson(origin, source);
  else
    std::printf("%.0f triangles estimated; smooth vessels of this size have %.0f\n",
                expected.triangles, expected.smoothTriangles);
  for (const std::string& warning : warningsOf(expected)) printWarning(warning);
  if (const auto why = refusal(expected, params, SurfaceLimits::ofMachine()))
    printWarning("such a surface is not begun: " + *why);
  return Done;
}

int mesh(const MeshOptions& options, const Progress& progress) {
  if (options.estimate != options.output.empty())
    throw InputError(options.estimate ? "an estimate writes no mesh" : "no mesh to write is named",
                     "-o", "give either -o or --estimate");
  if (!options.estimate) {
    checkMeshName(options.output);
    checkOutputFile(options.output);
  }
  const Parameters all = options.settings.parameters();
  const SurfaceParams& params = all.surface;
  const MeshInput input =
      readMeshInput(options.input, options.choice, &all, progress.sub(0.0, 0.3));
  const SplineField field = wallField(input.phi, params.spline);
  const Progress rest = progress.sub(0.3, 1.0);
  std::vector<std::string> remarks;
  const CutAway away = makeCuts(field, input.phi, all.ports, remarks, rest.sub(0.0, 0.1));
  for (const std::string& remark : remarks) printWarning(remark);
  if (options.estimate)
    return estimate(input, field, away, options, params, sourceBlock(input, nullptr), rest);
  const auto expect = [&](const GuidanceField& size) {
    const ExpectedSurface expected =
        expectSurface(field, size, params, allComponents(input.phi, rest), away);
    checkExpected(expected, params);
    for (const std::string& warning : warningsOf(expected)) printWarning(warning);
    return expected;
  };
  MadeSurface made = makeSurface(input.phi, field, params, rest.sub(0.1, 0.9), away,
                                 all.segmentation.keep == KeepComponents::Largest, expect);
  if (made.mesh.triangles.empty())
    throw InputError("there is no surface in it", options.input,
                     "give a level set function that is negative inside, or a mask");
  // Flat triangles inscribed in a thin vessel lose more of the mask's volume than its wall does.
  std::size_t left = 0;
  if (!input.labels.empty())
    made.mesh =
        smoothSurface(made.mesh, all.smooth, &field, rest.sub(0.9, 0.97), made.ports, &left);
  if (left > 0) printWarning(leftUnsmoothed(left));
  Soundness soundness = options.soundness;
  soundness.fault =
      surfaceFault(made.mesh, params.border == SurfaceBorder::Cap, nullptr, rest.sub(0.97, 1.0));
  if (soundness.fault.empty()) soundness.fault = made.origin.fault();
  if (!soundness.mayWrite()) {
    for (const std::string& warning : made.origin.warnings()) printWarning(warning);
    return soundness.refuse("nothing was written",
                            "smooth the image or the mask there, or choose longer edges "
                            "(surface.edgeMinMm) or surface.method=marching-cubes");
  }
  measureSlants(field, input.phi, made.ports);
  for (const std::string& warning : namePorts(all.ports, made.ports)) printWarning(warning);
  MeshWriteOptions write;
  // Of what it was made of; it also says that the names are ours.
  write.key = contentHash(input.phi);
  write.patchNames = patchNamesOf(made.ports);
  if (meshExtension(options.output) == ".stl") {
    // A text STL file alone has names, which who cuts or names openings wants.
    if (!away.empty() || !all.ports.names.empty())
      write.encoding = MeshEncoding::Ascii;
    else
      made.mesh.patch.clear();
  }
  writeChecked(made.mesh, options.output, options.output, write);
  for (const std::string& warning : made.origin.warnings()) printWarning(warning);
  for (const std::string& warning : slantWarnings(made.ports)) printWarning(warning);
  const Json source = sourceBlock(input, &made.mesh);
  if (input.atBorder) sayBorder(input, made.mesh, !away.empty());
  if (options.json) {
    printJson(made.origin, source);
  } else {
    printSurface(made.mesh.triangles.size(), made.origin);
    printPorts(made.ports);
    printSource(source);
  }
  return Done;
}

}  // namespace

void addMesh(CLI::App& program, Session& session) {
  auto options = std::make_shared<MeshOptions>();
  CLI::App* command =
      program.add_subcommand("mesh",
                             "The surface of a level set function, not smoothed; of a mask or "
                             "label image, moved outwards by "
                             "smooth.method so that its triangles hold the mask's volume");
  command->add_option("INPUT", options->input, "Level set function, mask or label image")
      ->required();
  addMaskChoice(*command, options->choice);
  command->add_option("-o,--output", options->output, "Mesh to write: " + meshEndings(true));
  command->add_flag("--estimate", options->estimate,
                    "Only estimate the number of triangles; writes nothing");
  command->add_flag("--json", options->json,
                    "Print the block 'surface' of report.json, and 'source'");
  addSoundness(*command, options->soundness);
  addSettings(*command, options->settings);
  addCuts(*command, options->settings);
  setAction(command, session, options, mesh);
}

}  // namespace angiomesh::cli

// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/field_input.h"
#include "app/cli/options.h"
#include "app/cli/output_folder.h"
#include "app/cli/summary.h"
#include "core/base/error.h"
#include "core/pipeline/report.h"
#include "core/pipeline/surface_step.h"
#include "io/mesh_io.h"

namespace angiomesh::cli {
namespace {

struct MeshOptions {
  ParameterOptions settings;
  std::string input, output;
  bool estimate = false, json = false;
};

int estimate(const SplineField& field, const MeshOptions& options, const SurfaceParams& params,
             const Progress& progress) {
  if (params.method == SurfaceMethod::MarchingCubes)
    throw InputError("marching cubes follows no size that could be estimated", "--estimate",
                     "choose surface.method advancing-front or remesh");
  SurfaceOrigin origin;
  origin.method = params.method;
  origin.estimatedTriangles = estimateTriangles(field, params, progress);
  if (options.json)
    std::fputs(surfaceJson(origin).c_str(), stdout);
  else
    std::printf("%.0f triangles estimated\n", *origin.estimatedTriangles);
  return Done;
}

int mesh(const MeshOptions& options, const Progress& progress) {
  if (options.estimate != options.output.empty())
    throw InputError(options.estimate ? "an estimate writes no mesh" : "no mesh to write is named",
                     "-o", "give either -o or --estimate");
  if (!options.estimate) checkOutputFile(options.output);
  const SurfaceParams params = options.settings.parameters().surface;
  const Volume<float> phi = readPhiOrMask(options.input);
  const SplineField field(phi, params.spline);
  if (options.estimate) return estimate(field, options, params, progress);
  const MadeSurface made = makeSurface(phi, field, params, progress);
  if (made.mesh.triangles.empty())
    throw InputError("there is no surface in it", options.input,
                     "give a level set function that is negative inside, or a mask");
  for (const std::string& warning : writeMesh(made.mesh, options.output))
    printWarning(warning + ", " + options.output);
  for (const std::string& warning : made.origin.warnings()) printWarning(warning);
  if (options.json)
    std::fputs(surfaceJson(made.origin).c_str(), stdout);
  else
    printSurface(made.mesh.triangles.size(), made.origin);
  return Done;
}

}  // namespace

void addMesh(CLI::App& program, Session& session) {
  auto options = std::make_shared<MeshOptions>();
  CLI::App* command = program.add_subcommand(
      "mesh", "The surface of a level set function or mask, not smoothed (--set surface.*=...)");
  command->add_option("INPUT", options->input, "Level set function or mask")->required();
  command->add_option("-o,--output", options->output, "Mesh to write: .ply, .stl, .obj or .vtp");
  command->add_flag("--estimate", options->estimate,
                    "Only estimate the number of triangles; writes nothing");
  command->add_flag("--json", options->json, "Print the block 'surface' of report.json");
  addSettings(*command, options->settings);
  command->callback([options, &session] {
    session.action = [options, &session] { return mesh(*options, session.progress); };
  });
}

}  // namespace angiomesh::cli

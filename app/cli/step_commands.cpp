// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/session/field_input.h"
#include "app/session/mesh_files.h"
#include "app/session/options.h"
#include "core/field/spline_field.h"
#include "core/field/wall_field.h"
#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/mesh_quality.h"
#include "core/smooth/smoothing.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"

namespace angiomesh::cli {
namespace {

struct StepOptions {
  ParameterOptions settings;
  ReadOptions reading;
  Soundness soundness;
  MeshReading meshReading;
  std::string input, output, phi, method;
  MaskChoice choice;
};

RunResult runUntil(Step step, const StepOptions& options, const Progress& progress) {
  Parameters params = options.settings.parameters();
  if (!options.method.empty()) setFieldFromText(params, "segmentation.method", options.method);
  LoadedImage loaded = readImage(options.input, options.reading, progress.sub(0.0, 0.05));
  printWarnings(loaded.info);
  Pipeline pipeline(makeSource(std::move(loaded.image), "input"));
  RunOptions runOptions;
  runOptions.until = step;
  RunResult result = pipeline.run(params, runOptions, progress.sub(0.05, 1.0));
  for (const StageReport& stage : result.stages)
    for (const std::string& warning : stage.warnings) printWarning(warning);
  return result;
}

int vesselnessCommand(const StepOptions& options, const Progress& progress) {
  const RunResult result = runUntil(Step::Vesselness, options, progress);
  writeVolume(*result.vesselness->multiScale, options.output);
  return Done;
}

int segmentCommand(const StepOptions& options, const Progress& progress) {
  // The components to keep are chosen by the step 'surface'.
  const RunResult result = runUntil(Step::Surface, options, progress);
  writeVolume(*result.surface->phi, options.output);
  std::printf("%zu voxels inside", result.surface->insideVoxels);
  if (evolves(result.params)) std::printf(", %d iterations", result.evolve->iterations);
  std::printf("\n");
  return Done;
}

int smoothCommand(const StepOptions& options, const Progress& progress) {
  checkMeshName(options.output);
  Soundness soundness = options.soundness;
  const Parameters params = options.settings.parameters();
  const LoadedMesh loaded = loadMesh(options.input, options.meshReading.options());
  for (const std::string& warning : loaded.warnings) printWarning(warning);
  std::optional<SplineField> phi;
  if (!options.phi.empty()) {
    const MeshInput input =
        readMeshInput(options.phi, options.choice, &params, progress.sub(0.0, 0.3));
    phi = wallField(input.phi, params.surface.spline);
  }
  std::size_t left = 0;
  const TriMesh smooth = smoothSurface(loaded.mesh, params.smooth, phi ? &*phi : nullptr,
                                       progress.sub(0.3, 0.9), {}, &left);
  if (left > 0) printWarning(leftUnsmoothed(left));
  soundness.fault = surfaceFault(smooth, false, nullptr, progress.sub(0.9, 1.0));
  if (!soundness.mayWrite())
    return soundness.refuse("nothing was written",
                            surfaceFault(loaded.mesh, false).empty()
                                ? "smooth less (smooth.iterations)"
                                : "it was so before: repair or make the surface anew");
  MeshWriteOptions write;
  write.key = loaded.key;
  bool numbered = false;
  write.patchNames = plainPatchNames(loaded, numbered);
  writeChecked(smooth, options.output, options.output, write);
  return Done;
}

std::shared_ptr<StepOptions> addStep(CLI::App& program, Session& session, const char* name,
                                     const char* help, const char* input, const std::string& output,
                                     int (*body)(const StepOptions&, const Progress&)) {
  auto options = std::make_shared<StepOptions>();
  CLI::App* command = program.add_subcommand(name, help);
  command->add_option("INPUT", options->input, input)->required();
  command->add_option("-o,--output", options->output, output)->required();
  addSettings(*command, options->settings);
  command->callback([options, &session, body] {
    session.action = [options, &session, body] {
      checkOutputFile(options->output);
      return body(*options, session.progress);
    };
  });
  return options;
}

void addImageOptions(CLI::App& program, const char* name, StepOptions& options) {
  CLI::App* command = program.get_subcommand(name);
  addReading(*command, options.reading);
  addPlaces(*command, options.settings);
}

}  // namespace

void addVesselness(CLI::App& program, Session& session) {
  const auto options =
      addStep(program, session, "vesselness", "The vesselness of an image, on the working grid",
              "Image file or DICOM folder", "Volume to write", vesselnessCommand);
  addImageOptions(program, "vesselness", *options);
}

void addSegment(CLI::App& program, Session& session) {
  const auto options = addStep(program, session, "segment",
                               "The level set function of the vessels, mm, negative inside",
                               "Image file or DICOM folder", "Volume to write", segmentCommand);
  addImageOptions(program, "segment", *options);
  program.get_subcommand("segment")->add_option(
      "--method", options->method,
      "As segmentation.method: level-set, geodesic-active-contour, "
      "confidence-connected or threshold");
}

void addSmooth(CLI::App& program, Session& session) {
  const auto options = addStep(program, session, "smooth", "Smooth a mesh", "Mesh",
                               "Mesh to write: " + meshEndings(true), smoothCommand);
  CLI::App* command = program.get_subcommand("smooth");
  addSoundness(*command, options->soundness);
  addMeshReading(*command, options->meshReading);
  command->add_option(
      "--phi", options->phi,
      "Level set function, mask or label image whose wall 'keep-wall' keeps (else the mesh's)");
  addMaskChoice(*command, options->choice);
}

}  // namespace angiomesh::cli

// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/session/field_input.h"
#include "app/session/mesh_files.h"
#include "app/session/options.h"
#include "app/session/summary.h"
#include "core/base/error.h"
#include "core/image/projection.h"
#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "core/pipeline/segmentation_mask.h"
#include "core/pipeline/segments.h"
#include "core/quality/mesh_quality.h"
#include "core/quality/overlap.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/mesh/mesh_io.h"
#include "io/recipe/methods_text.h"
#include "io/recipe/recipe_file.h"
#include "io/scan/image_io.h"
#include "io/vessel/ports_file.h"
#include "io/volume/image_write.h"

namespace angiomesh::cli {
namespace {

// Shares of the whole job's progress.
constexpr double kLoaded = 0.02;
constexpr double kComputed = 0.95;

/// All files that a run may leave; surface.png is the picture that `snapshot` adds.
const std::vector<std::string> kRunFiles{
    "preprocessed.nrrd", "vesselness.nrrd", "phi.nrrd",           "mask.nrrd",   "vessels.ply",
    "vessels.stl",       "recipe.json",     "marching-cubes.ply", "report.json", "preview.png",
    "surface.png",       "ports.json",      "methods.txt",        "params.json"};

struct RunCommandOptions {
  ParameterOptions settings;
  ReadOptions reading;
  std::string input, output, until = "quality", truth;
  Soundness soundness;
  bool force = false;
};

Step stepOf(const std::string& until) {
  const std::optional<Step> step = stepFromId(until);
  if (!step || *step == Step::Load)
    throw InputError(
        "no step is called '" + until + "'", "--until",
        "use preprocess, vesselness, seeds, evolve, correct, surface, smooth or quality");
  return *step;
}

double processorSeconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

struct Loaded {
  Source source;
  StageReport stage;
};

Loaded load(const RunCommandOptions& options, const Progress& progress) {
  progress.phase("load");
  const auto start = std::chrono::steady_clock::now();
  const double cpu = processorSeconds();
  LoadedImage loaded = readImage(options.input, options.reading, progress);
  Loaded result;
  result.stage.step = Step::Load;
  printWarnings(loaded.info);
  result.stage.warnings = reportWarnings(loaded.info);
  result.source = makeSource(std::move(loaded.image), "input");
  result.stage.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.stage.cpuSeconds = processorSeconds() - cpu;
  return result;
}

/// Puts the time and the warnings of loading into the result's list of stages.
void addLoadStage(RunResult& result, const StageReport& stage) {
  auto& stages = result.stages;
  if (!stages.empty() && stages.front().step == Step::Load) stages.erase(stages.begin());
  stages.insert(stages.begin(), stage);
  result.totalSeconds += stage.seconds;
  result.cpuSeconds += stage.cpuSeconds;
}

/// The phi that was meshed, or of what the evolution found; of a surface that failed, all of it.
std::shared_ptr<const Volume<float>> finalPhi(const RunResult& result) {
  return result.failure && result.evolve && !result.surface ? result.segmentation()->phi
                                                            : keptPhi(result);
}

template <class T>
void addVolume(const StagedFolder& folder, const char* name, const Volume<T>& volume) {
  folder.add(name, [&](const std::filesystem::path& place) { writeVolume(volume, place); });
}

void addText(const StagedFolder& folder, const char* name, const std::string& text) {
  folder.add(name, [&](const std::filesystem::path& place) { writeText(place, text); });
}

void writeVolumes(const RunResult& result, Step until, const Volume<float>* phi,
                  const StagedFolder& folder) {
  if (until == Step::Preprocess) addVolume(folder, "preprocessed.nrrd", *result.preprocessed);
  if (until == Step::Vesselness || until == Step::Seeds)
    addVolume(folder, "vesselness.nrrd", *result.vesselness->multiScale);
  if (phi != nullptr) {
    const Geometry& grid = result.source.image->geometry;
    addVolume(folder, "phi.nrrd", *phi);
    addVolume(folder, "mask.nrrd", segmentationMask(result, *phi, grid));
  }
}

/// What a solver could not take of the last mesh, in words.
std::string faultOf(const RunResult& result, const Progress& progress) {
  const TriMesh* mesh = finalMesh(result);
  if (mesh == nullptr) return {};
  const bool closed = result.params.surface.border == SurfaceBorder::Cap;
  return surfaceFault(*mesh, closed, result.quality ? &result.quality->mesh : nullptr, progress);
}

void writeMarchingCubes(const RunResult& result, const StagedFolder& folder) {
  if (!result.surface) return;
  MeshWriteOptions write;
  write.key = result.key;
  folder.add("marching-cubes.ply", [&](const std::filesystem::path& place) {
    writeChecked(*result.surface->marchingCubes, place, "marching-cubes.ply", write);
  });
}

void writeSurface(const RunResult& result, const StagedFolder& folder) {
  MeshWriteOptions write;
  write.key = result.key;
  const TriMesh* mesh = finalMesh(result);
  if (mesh == nullptr) return;
  const auto add = [&](const char* name, const TriMesh& what) {
    folder.add(name,
               [&](const std::filesystem::path& place) { writeChecked(what, place, name, write); });
  };
  write.patchNames = patchNamesOf(result.ports);
  add("vessels.ply", *mesh);
  folder.add("ports.json",
             [&](const std::filesystem::path& place) { writePorts(result.ports, place); });
  addText(folder, "methods.txt", methodsText(result));
  // Who cuts or names openings wants their names, which only the text form has.
  if (!result.surface->sectionAreasMm2.empty() || !result.params.ports.names.empty()) {
    write.encoding = MeshEncoding::Ascii;
    add("vessels.stl", *mesh);
  } else {
    TriMesh plain = *mesh;
    plain.patch.clear();
    write.patchNames.clear();
    add("vessels.stl", plain);
  }
}

int run(const RunCommandOptions& options, const Progress& progress) {
  const Recipe recipe = options.settings.recipe();
  RunOptions runOptions;
  runOptions.keepResults = false;
  runOptions.keepOnFailure = true;
  runOptions.warned = [](Step, const std::string& warning) { printWarning(warning); };
  runOptions.until = stepOf(options.until);
  if (!options.truth.empty() && runOptions.until < Step::Evolve)
    throw InputError("there is nothing to compare before the step 'evolve'", "--truth",
                     "leave out --truth, or run further with --until");
  StagedFolder folder(options.output, kRunFiles, options.force);

  std::optional<Volume<std::uint8_t>> truth;
  if (!options.truth.empty()) truth = readTruth(options.truth);
  const Loaded loaded = load(options, progress.sub(0.0, kLoaded));
  for (const std::string& warning : recipeWarnings(recipe, loaded.source)) printWarning(warning);
  Pipeline pipeline(loaded.source);
  RunResult result = pipeline.run(recipe.params, runOptions, progress.sub(kLoaded, kComputed));
  addLoadStage(result, loaded.stage);

  const Progress writing = progress.sub(kComputed, 1.0);
  writing.phase("write");
  const std::shared_ptr<const Volume<float>> phi = finalPhi(result);
  std::optional<OverlapMeasures> measures;
  if (truth) measures = compareMasks(segmentationMask(result, *phi, truth->geometry), *truth);
  writing.report(0.2);
  writeVolumes(result, runOptions.until, phi.get(), folder);
  writing.report(0.4);
  Soundness soundness = options.soundness;
  if (!result.failure) soundness.fault = faultOf(result, writing);
  if (soundness.fault.empty() && result.surface) soundness.fault = result.surface->origin.fault();
  const bool sound = soundness.mayWrite();
  if (!result.failure) {
    if (sound) writeSurface(result, folder);
    writeMarchingCubes(result, folder);
  }
  writing.report(0.7);
  if (phi)
    folder.add("preview.png", [&](const std::filesystem::path& place) {
      writePng(previewPicture(*loaded.source.image, *phi), place);
    });
  addText(folder, "params.json", parametersToJson(recipe.params));
  addText(folder, "recipe.json", recipeText(recipeOf(recipe.params, loaded.source)));
  addText(folder, "report.json", runReportJson(result, measures));
  writing.report(1.0);
  folder.commit();
  printSummary(result, measures);
  if (result.failure) {
    printError(result.failure->why +
               "; what was computed before is kept, phi.nrrd and mask.nrrd in " + options.output);
    return UserCanChange;
  }
  if (!sound)
    return soundness.refuse(
        "the rest of the result was written without it",
        "look at its place in the image, and smooth more (preprocess.*), choose "
        "longer edges (surface.edgeMinMm) or surface.method=marching-cubes");
  return Done;
}

}  // namespace

void addRun(CLI::App& program, Session& session) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = program.add_subcommand("run", "The whole pipeline: an image in, a mesh out");
  command->add_option("INPUT", options->input, "Image file or DICOM folder")->required();
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  addReading(*command, options->reading);
  addSettings(*command, options->settings);
  addPlaces(*command, options->settings);
  addCuts(*command, options->settings);
  command->add_option("--until", options->until,
                      "Last step: preprocess, vesselness, seeds, evolve, correct, surface, smooth, "
                      "quality");
  addSoundness(*command, options->soundness);
  command->add_option("--truth", options->truth, "Mask to compare the result with");
  command->add_flag("--force", options->force, "Replace a former run in the output folder");
  setAction(command, session, options, run);
}

}  // namespace angiomesh::cli

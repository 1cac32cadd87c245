// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/study_sensitivity_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/session/options.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/sensitivity/sensitivity.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh::cli {
namespace {

struct SensitivityOptions {
  ParameterOptions settings;
  ReadOptions reading;
  std::string input, output;
  std::vector<std::string> keys;
  double step = 1.0;
  bool force = false;
};

constexpr const char* kLegend =
    "Moves of the wall outwards at the vertices of the unchanged one. What is lost counts for no "
    "mean.\n";

std::string arrow(const ParameterStep& step) {
  return shortestText(std::round(step.from * 1e4) / 1e4) + " -> " +
         shortestText(std::round(step.to * 1e4) / 1e4);
}

/// "levelset.xi+" of a step up.
std::string nameOf(const ParameterStep& step) { return step.key + (step.up ? "+" : "-"); }

std::string markdown(const Sensitivity& found) {
  std::string text =
      "| parameter | step | mean move, mm | mean size, mm | 95 %, mm | lost, % | volume, % | "
      "overlap, "
      "% |\n|---|---|---:|---:|---:|---:|---:|---:|\n";
  for (const StepEffect& effect : found.effects) {
    text += "| " + effect.step.key + " | " + arrow(effect.step) + " | ";
    const WallMoves& m = effect.moves;
    text += effect.why.empty()
                ? formatted("%+.4f | %.4f | %.4f | %.2f | %+.2f | %.2f |\n", m.meanMm, m.meanSizeMm,
                            m.p95Mm, m.lostPercent, m.volumePercent, m.overlapPercent)
                : effect.why + " | | | | | |\n";
  }
  return text + "\n" + kLegend;
}

std::string csv(const Sensitivity& found) {
  std::string text =
      "parameter,from,to,mean_mm,mean_size_mm,p95_mm,lost_percent,volume_percent,overlap_percent,"
      "failure\n";
  for (const StepEffect& effect : found.effects) {
    const WallMoves& m = effect.moves;
    text += effect.step.key + "," + shortestText(effect.step.from) + "," +
            shortestText(effect.step.to) + ",";
    text += effect.why.empty()
                ? formatted("%.6f,%.6f,%.6f,%.4f,%.4f,%.4f,", m.meanMm, m.meanSizeMm, m.p95Mm,
                            m.lostPercent, m.volumePercent, m.overlapPercent)
                : ",,,,,,\"" + effect.why + "\"";
    text += "\n";
  }
  return text;
}

/// A line for each branch: where it is, and by how much each step changes its radius.
std::string branches(const Sensitivity& found) {
  std::string text = "branch,component,length_mm,mean_radius_mm,middle_x,middle_y,middle_z,places";
  for (const StepEffect& effect : found.effects)
    if (effect.why.empty())
      text += "," + nameOf(effect.step) + "," + nameOf(effect.step) + " lost_percent";
  text += "\n";
  const std::vector<SkeletonBranch>& all = found.places.skeleton.branches;
  for (std::size_t b = 0; b < all.size(); ++b) {
    const SkeletonBranch& branch = all[b];
    const Eigen::Vector3d& middle = branch.points[branch.points.size() / 2].pointLps;
    std::size_t places = 0;
    std::string moves;
    for (const StepEffect& effect : found.effects) {
      if (!effect.why.empty()) continue;
      const WallMoves::Branch& one = effect.moves.branches[b];
      places = one.places;
      moves += formatted(",%.5f,%.2f", one.meanMm, one.lostPercent);
    }
    text +=
        formatted("%zu,%d,%.3f,%.4f,%.3f,%.3f,%.3f,%zu", b + 1, branch.component, branch.lengthMm,
                  branch.meanRadiusMm, middle[0], middle[1], middle[2], places) +
        moves + "\n";
  }
  return text;
}

/// The wall with its largest move, and that of each step.
void writeWall(const Sensitivity& found, const std::filesystem::path& place) {
  MeshWriteOptions options;
  options.pointValues.emplace_back("spread_mm", found.spreadMm);
  for (const StepEffect& effect : found.effects)
    if (effect.why.empty())
      options.pointValues.emplace_back(nameOf(effect.step), effect.moves.movedMm);
  writeMesh(found.places.wall, place, options);
}

int sensitivity(const SensitivityOptions& options, const Progress& progress) {
  const Parameters params = options.settings.parameters();
  if (isSegmented(params))
    throw InputError("the wall of a segmentation depends on no such parameter",
                     "segmentation.method", "give a scan");
  StagedFolder folder(options.output,
                      {"sensitivity.md", "sensitivity.csv", "branches.csv", "sensitivity.vtp"},
                      options.force);
  progress.phase("load");
  LoadedImage loaded = readImage(options.input, options.reading, progress.sub(0.0, 0.02));
  printWarnings(loaded.info);
  Pipeline pipeline(makeSource(std::move(loaded.image), "input"));
  RunOptions until;
  until.until = Step::Correct;
  const RunResult base = pipeline.run(params, until, progress.sub(0.02, 0.1));
  const std::vector<ParameterStep> steps =
      parameterSteps(params, contextOf(base), options.keys, options.step);
  const Sensitivity found = sensitivityOf(pipeline, params, steps, progress.sub(0.1, 0.98));
  folder.add("sensitivity.md", [&](const auto& place) { writeText(place, markdown(found)); });
  folder.add("sensitivity.csv", [&](const auto& place) { writeText(place, csv(found)); });
  folder.add("branches.csv", [&](const auto& place) { writeText(place, branches(found)); });
  folder.add("sensitivity.vtp", [&](const auto& place) { writeWall(found, place); });
  folder.commit();
  std::printf("%s", markdown(found).c_str());
  return Done;
}

}  // namespace

void addStudySensitivity(CLI::App& study, Session& session) {
  auto options = std::make_shared<SensitivityOptions>();
  CLI::App* command = study.add_subcommand("sensitivity",
                                           "How much the wall of a scan's vessels moves when each "
                                           "parameter is moved a step up and down");
  command->add_option("INPUT", options->input, "Image file or DICOM folder")->required();
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  addReading(*command, options->reading);
  addSettings(*command, options->settings);
  addPlaces(*command, options->settings);
  command->add_option("--parameter", options->keys,
                      "Only this one, such as levelset.xi (repeatable); else all main ones");
  command
      ->add_option("--step", options->step,
                   "Size of a step: 1 is a tenth of the slider, or a factor of 1.25")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  command->add_flag("--force", options->force, "Replace a former study in the output folder");
  setAction(command, session, options, sensitivity);
}

}  // namespace angiomesh::cli

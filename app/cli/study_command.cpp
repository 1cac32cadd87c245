// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/study_panel_command.h"
#include "app/cli/study_sensitivity_command.h"
#include "app/cli/study_surface_command.h"
#include "app/cli/study_table.h"
#include "app/session/field_input.h"
#include "app/session/options.h"
#include "app/study/study_figures.h"
#include "app/study/study_segmentation.h"
#include "core/base/formatted.h"
#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/scan/image_io.h"
#include "render/picture/mesh_panels.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPanelWidth = 620;
constexpr int kPanelHeight = 480;
constexpr double kDetailVoxels = 14.0;
constexpr std::uint64_t kNoiseSeed = 1;
constexpr double kImageNoise = 60.0;  // of the thesis's synthetic image in these figures

struct FiguresOptions {
  ReadOptions reading;
  std::string input, image, output;
  ParameterOptions settings;  ///< of the segmentations
  int size = 96;
  double noise = 0.1;
  bool force = false;
};

/// A tree of tapering vessels with a bridge, as rough as a segmentation leaves it.
Volume<float> phantomTree(const FiguresOptions& options) {
  PhantomParams params;
  params.kind = PhantomKind::CapsuleTree;
  params.size = {options.size, options.size, options.size};
  params.radius = options.size / 22.0;
  Volume<float> phi = phantomField(params);
  const double sigma = options.noise * phi.geometry.voxelMm();
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    phi.voxels[i] += static_cast<float>(sigma * randomNormal(kNoiseSeed, i));
  return phi;
}

std::string fileOf(const std::string& number) { return "figure-" + number + ".png"; }

Json jsonOf(const std::string& title, const PanelRecipe& recipe, const PanelResult& panel,
            double voxelMm) {
  const MeshQuality& q = panel.quality;
  Json json;
  json["title"] = title;
  json["method"] = recipe.marchingCubes ? "marching-cubes" : "advancing-front";
  if (!recipe.marchingCubes) {
    json["spline"] = recipe.spline == SplineKind::CatmullRom ? "catmull-rom" : "bspline";
    json["rho"] = recipe.sizing.rho;
    json["eta_inverse"] = recipe.sizing.etaInverse;
    json["gradation"] = recipe.gradation;
  }
  json["smoothing"] = recipe.taubin ? "taubin" : "none";
  json["seconds"] = panel.seconds;
  json["triangles"] = q.triangles;
  json["min_angle_min"] = q.minAngleMin;
  json["min_angle_mean"] = q.minAngleMean;
  json["below_30_percent"] = q.below30Percent;
  json["max_angle_max"] = q.maxAngleMax;
  json["radius_ratio_mean"] = q.radiusRatioMean;
  json["radius_ratio_min"] = q.radiusRatioMin;
  json["edge_mean_mm"] = q.edgeMeanMm;
  if (q.vertexDeviation) {
    json["vertex_deviation_mean_voxels"] = q.vertexDeviation->meanMm / voxelMm;
    json["vertex_deviation_max_voxels"] = q.vertexDeviation->maxMm / voxelMm;
  }
  json["components"] = q.components;
  json["genus"] = q.genus;
  json["self_intersections"] = q.selfIntersections;
  return json;
}

std::string rowOf(const std::string& number, const Json& panel) {
  return formatted("| %s | %s | %zu | %.1f | %.2f | %.1f | %.3f | %.3f | %.4f |\n", number.c_str(),
                   panel["title"].get<std::string>().c_str(), panel["triangles"].get<std::size_t>(),
                   panel["min_angle_min"].get<double>(), panel["below_30_percent"].get<double>(),
                   panel["max_angle_max"].get<double>(), panel["radius_ratio_mean"].get<double>(),
                   panel["radius_ratio_min"].get<double>(),
                   panel.value("vertex_deviation_mean_voxels", 0.0));
}

constexpr const char* kTableHead =
    "| figure | panel | triangles | smallest angle | under 30 deg, % | largest angle | 2r/R mean | "
    "2r/R min | vertex to the wall, voxels |\n|---|---|---|---|---|---|---|---|---|\n";

/// The figures of the segmentation into `json` and `folder`; returns their table.
std::string segmentation(const FiguresOptions& options, const StagedFolder& folder, Json& json,
                         const Progress& progress) {
  std::optional<Phantom> tree;
  LoadedImage loaded;
  if (options.image.empty()) {
    tree = thesisTree(options.size, kNoiseSeed, kImageNoise);
  } else {
    loaded = readImage(options.image, options.reading);
    printWarnings(loaded.info);
  }
  std::string table =
      "| figure | panel | voxels inside | components | iterations | overlap, % |\n"
      "|---|---|---|---|---|---|\n";
  for (const SegmentationFigure& made :
       segmentationFigures(tree ? tree->image : loaded.image, tree ? &tree->truth : nullptr,
                           options.settings.parameters(), progress)) {
    const std::string name = fileOf(made.number);
    Json figure{{"figure", made.number}, {"caption", made.caption}, {"file", name}};
    for (const SegmentationPanel& panel : made.panels) {
      Json one{{"title", panel.title},
               {"inside_voxels", panel.insideVoxels},
               {"components", panel.components},
               {"iterations", panel.iterations}};
      std::string overlap;
      if (panel.overlap) {
        one["overlap"] = *panel.overlap;
        overlap = formatted("%.2f", *panel.overlap);
      }
      table += "| " + made.number + " | " + panel.title + " | " +
               std::to_string(panel.insideVoxels) + " | " + std::to_string(panel.components) +
               " | " + std::to_string(panel.iterations) + " | " + overlap + " |\n";
      figure["panels"].push_back(std::move(one));
    }
    folder.add(name, [&](const auto& place) { writePng(made.picture, place); });
    json["figures"].push_back(std::move(figure));
  }
  return table;
}

/// The figures of the meshing into `json` and `folder`; returns their table.
std::string meshing(const FiguresOptions& options, const StagedFolder& folder, Json& json,
                    const Progress& progress) {
  const std::vector<FigurePlan> plans = thesisFigures();
  const Volume<float> phi =
      options.input.empty() ? phantomTree(options) : readPhiOrMask(options.input);
  const double voxel = phi.geometry.voxelMm();
  PanelMaker maker(phi);
  std::string table = kTableHead;
  std::optional<std::array<double, 6>> detail;
  for (std::size_t f = 0; f < plans.size(); ++f) {
    const FigurePlan& plan = plans[f];
    const Progress part =
        progress.sub(static_cast<double>(f) / static_cast<double>(plans.size()),
                     static_cast<double>(f + 1) / static_cast<double>(plans.size()));
    Json figure{{"figure", plan.number}, {"caption", plan.caption}, {"file", fileOf(plan.number)}};
    std::vector<MeshPanel> panels;
    for (const auto& [title, recipe] : plan.panels) {
      const double done =
          static_cast<double>(panels.size()) / static_cast<double>(plan.panels.size());
      const PanelResult& panel = maker.make(recipe, part.sub(done, 1.0));
      figure["panels"].push_back(jsonOf(title, recipe, panel, voxel));
      table += rowOf(plan.number, figure["panels"].back());
      panels.push_back(
          {&panel.mesh, title + ": " + std::to_string(panel.quality.triangles) + " triangles"});
    }
    if (!detail) detail = busiestBox(*panels.back().mesh, kDetailVoxels * voxel);
    const Picture picture = renderMeshPanels(panels, *detail, kPanelWidth, kPanelHeight);
    folder.add(fileOf(plan.number), [&](const auto& place) { writePng(picture, place); });
    json["figures"].push_back(std::move(figure));
  }
  return table;
}

/// Of the phantoms both kinds; of what is given, the kind that it is for.
int figures(const FiguresOptions& options, const Progress& progress) {
  const bool segments = options.input.empty() || !options.image.empty();
  const bool meshes = options.image.empty() || !options.input.empty();
  std::vector<std::string> names{"figures.json", "figures.md"};
  for (const FigurePlan& plan : thesisFigures()) names.push_back(fileOf(plan.number));
  for (const std::string& number : segmentationFigureNumbers()) names.push_back(fileOf(number));
  StagedFolder folder(options.output, names, options.force);

  Json json;
  json["schema"] = 1;
  json["phantom"] = options.input.empty() && options.image.empty();
  std::string tables;
  if (segments)
    tables += segmentation(options, folder, json, progress.sub(0.0, meshes ? 0.5 : 1.0)) + "\n";
  if (meshes) tables += meshing(options, folder, json, progress.sub(segments ? 0.5 : 0.0, 1.0));
  folder.add("figures.json", [&](const auto& place) { writeText(place, json.dump(2) + "\n"); });
  folder.add("figures.md", [&](const auto& place) { writeText(place, tables); });
  folder.commit();
  std::printf("%s", tables.c_str());
  return Done;
}

}  // namespace

void addStudy(CLI::App& program, Session& session) {
  CLI::App* study = program.add_subcommand("study", kStudyText);
  study->require_subcommand(1);
  addTableA(*study, session);
  addStudyPanel(*study, session);
  addStudyPorts(*study, session);
  addStudySurface(*study, session);
  addStudySensitivity(*study, session);
  auto options = std::make_shared<FiguresOptions>();
  CLI::App* command =
      study->add_subcommand("figures",
                            "Figures 3.3, 5.2, A.1, A.2 and A.3: the segmentation; 4.1, "
                            "5.4, 5.5, 5.6, B.1 and B.2: the meshing (needs an X "
                            "display, a virtual one will do)");
  command->add_option("PHI", options->input,
                      "Level set function or mask: only the figures of the meshing, of it; a "
                      "phantom tree unless given");
  command->add_option("--image", options->image,
                      "Image: only the figures of the segmentation, of it");
  command->add_option("--series", options->reading.series,
                      "Series UID, where the image is a DICOM folder "
                      "that holds several");
  options->settings.presetName = "thesis";
  addSettings(*command, options->settings);
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  command->add_option("--size", options->size, "Voxels along each side of the phantom")
      ->check(CLI::Range(32, 512))
      ->capture_default_str();
  command->add_option("--noise", options->noise, "Roughness of the phantom's wall, voxels")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_flag("--force", options->force, "Replace the figures of a former call");
  setAction(command, session, options, figures);
}

}  // namespace angiomesh::cli

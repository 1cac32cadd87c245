// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/study_surface_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/commands.h"
#include "app/session/options.h"
#include "app/session/wall_text.h"
#include "app/study/study_surface.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "core/quality/quality_json.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SurfaceOptions {
  ParameterOptions settings;
  std::string output, shapes, noises = "0,20,60", psfs = "gaussian:0.5";
  std::uint64_t seed = 1;
  bool force = false;
};

/// A column of the tables.
struct Column {
  const char* title;
  int decimals;
  double (*value)(const SurfaceCase&);  ///< NaN where there is none
};

double roughnessOf(const SurfaceCase& c) {
  const auto& roughness = c.exported.quality.roughness;
  return roughness ? roughness->spreadMm / c.voxelMm : std::nan("");
}

const std::vector<Column>& columns() {
  using Case = const SurfaceCase&;
  static const std::vector<Column> list{
      {"mean", 3, [](Case c) { return c.exported.wall.all.meanMm / c.voxelMm; }},
      {"spread", 3, [](Case c) { return c.exported.wall.all.spreadMm / c.voxelMm; }},
      {"95 %", 3, [](Case c) { return c.exported.wall.all.distance95Mm / c.voxelMm; }},
      {"normals", 2, [](Case c) { return c.exported.wall.all.normalMeanDeg; }},
      {"normals 95 %", 2, [](Case c) { return c.exported.wall.all.normal95Deg; }},
      {"curvature", 3, [](Case c) { return c.exported.wall.all.curvatureErrorMedian; }},
      {"mean r 1.3-2", 3, [](Case c) { return c.exported.wall.byRadius[0].meanMm / c.voxelMm; }},
      {"r 2-4", 3, [](Case c) { return c.exported.wall.byRadius[1].meanMm / c.voxelMm; }},
      {"r 4-5", 3, [](Case c) { return c.exported.wall.byRadius[2].meanMm / c.voxelMm; }},
      {"r > 5", 3, [](Case c) { return c.exported.wall.byRadius[3].meanMm / c.voxelMm; }},
      {"spread r 1.3-2", 3,
       [](Case c) { return c.exported.wall.byRadius[0].spreadMm / c.voxelMm; }},
      {"r 2-4", 3, [](Case c) { return c.exported.wall.byRadius[1].spreadMm / c.voxelMm; }},
      {"r 4-5", 3, [](Case c) { return c.exported.wall.byRadius[2].spreadMm / c.voxelMm; }},
      {"r > 5", 3, [](Case c) { return c.exported.wall.byRadius[3].spreadMm / c.voxelMm; }},
      {"roughness", 3, roughnessOf},
      {"angle", 2,
       [](Case c) {
         const auto& roughness = c.exported.quality.roughness;
         return roughness ? roughness->angleDeg : std::nan("");
       }},
      {"triangles", 0, [](Case c) { return static_cast<double>(c.exported.quality.triangles); }},
      {"to noise 0", 2, [](Case c) { return c.trianglesAgainstNoNoise.value_or(std::nan("")); }},
      {"genus", 0, [](Case c) { return static_cast<double>(c.exported.quality.genus); }},
      {"least angle", 1, [](Case c) { return c.exported.quality.minAngleMin; }},
      {"diameter, % off", 1,
       [](Case c) {
         return c.exported.wall.stenosis ? c.exported.wall.stenosis->errorPercent() : std::nan("");
       }},
      {"MC mean", 3, [](Case c) { return c.marchingCubes.wall.all.meanMm / c.voxelMm; }},
      {"MC spread", 3, [](Case c) { return c.marchingCubes.wall.all.spreadMm / c.voxelMm; }},
      {"MC normals", 2, [](Case c) { return c.marchingCubes.wall.all.normalMeanDeg; }},
      {"s", 1, [](Case c) { return c.seconds; }},
  };
  return list;
}

constexpr const char* kLegend =
    "Lengths in voxels of the smallest spacing, angles in degrees. mean, spread, 95 %: of the "
    "signed distance of the exported vertices to the true wall, positive outside (95 %: of its "
    "size). normals: between a triangle's and the wall's at the foot of its centroid. curvature: "
    "median of the relative error of the mean curvature. r a-b: of vessels of that radius. "
    "roughness, angle: as in report.json, known without the truth. to noise 0: triangles against "
    "the same shape without noise. diameter: the least one of the exported wall against the "
    "true one. MC: marching cubes on the same level set function. What lies within three quarters "
    "of a radius of a branching or at the volume's border does not count. s: the whole pipeline.\n";

std::string numberText(double value, int decimals) {
  return std::isnan(value) ? "" : formatted("%.*f", decimals, value);
}

std::string barText(const std::vector<SurfaceBar>& bars) {
  return joined(bars, "; ", &SurfaceBar::what);
}

std::string reachedText(const std::vector<SurfaceBar>& bars) {
  std::string missed;
  for (const SurfaceBar& bar : bars)
    if (!bar.reached) missed += (missed.empty() ? "no: " : ", ") + bar.name;
  return !missed.empty() ? missed : bars.empty() ? "" : "yes";
}

std::string markdown(const std::vector<SurfaceCase>& cases, const SurfaceOptions& options) {
  std::string text = "Preset `" + options.settings.presetName + "`, `segmentation.keep=largest`";
  for (const std::string& s : options.settings.settings) text += ", `" + s + "`";
  text += "; seed " + std::to_string(options.seed) + ".\n\n| shape | point spread | noise |";
  std::string rule = "|---|---|---:|";
  for (const Column& column : columns()) {
    text += " " + std::string(column.title) + " |";
    rule += "---:|";
  }
  text += " bar | reached |\n" + rule + "---|---|\n";
  for (const SurfaceCase& c : cases) {
    text += "| " + c.shape.name + " | " + pointSpreadText(c.shape.phantom.psf) + " | " +
            numberText(c.shape.phantom.noiseSigma, 0) + " |";
    for (const Column& column : columns())
      text += " " + (c.failure.empty() ? numberText(column.value(c), column.decimals) : "") + " |";
    const std::vector<SurfaceBar> bars = barsOf(c);
    text += " " + barText(bars) + " | " + reachedText(bars) + " |\n";
  }
  return text + "\n" + kLegend;
}

std::string csv(const std::vector<SurfaceCase>& cases) {
  std::string text = "shape,psf,noise";
  for (const Column& column : columns()) text += ",\"" + std::string(column.title) + "\"";
  text += ",reached\n";
  for (const SurfaceCase& c : cases) {
    text += c.shape.name + "," + pointSpreadText(c.shape.phantom.psf) + "," +
            numberText(c.shape.phantom.noiseSigma, 0);
    for (const Column& column : columns())
      text += "," + (c.failure.empty() ? numberText(column.value(c), 6) : "");
    text += ",\"" + reachedText(barsOf(c)) + "\"\n";
  }
  return text;
}

Json jsonOf(const SurfaceCase& c) {
  Json json{{"shape", c.shape.name},
            {"psf", pointSpreadText(c.shape.phantom.psf)},
            {"noise", c.shape.phantom.noiseSigma}};
  if (!c.failure.empty()) {
    json["failure"] = c.failure;
    return json;
  }
  json["voxel_mm"] = c.voxelMm;
  json["seconds"] = c.seconds;
  if (c.trianglesAgainstNoNoise) json["triangles_to_noise_0"] = *c.trianglesAgainstNoNoise;
  const auto meshOf = [&](const MeasuredMesh& mesh) {
    return Json{{"wall", wallJson(mesh.wall, c.voxelMm)},
                {"mesh", qualityJson<Json>(mesh.quality)}};
  };
  json["exported"] = meshOf(c.exported);
  json["marching_cubes"] = meshOf(c.marchingCubes);
  for (const SurfaceBar& bar : barsOf(c))
    json["bars"].push_back({{"bar", bar.what}, {"reached", bar.reached}});
  return json;
}

std::vector<double> noisesOf(const std::string& text) {
  const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
  std::vector<double> noises = parseNumbers(text, count, "--noise");
  std::sort(noises.begin(), noises.end());
  return noises;
}

std::vector<PointSpread> psfsOf(const std::string& text) {
  std::vector<PointSpread> psfs;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) psfs.push_back(pointSpreadFromText(word));
  if (psfs.empty())
    throw InputError("no point spread is named", "--psf", "name some, such as gaussian:0.5,mr");
  return psfs;
}

int surface(const SurfaceOptions& options, const Progress& progress) {
  const std::vector<SurfaceShape> shapes =
      chooseShapes(surfaceShapes(options.seed), options.shapes);
  const std::vector<double> noises = noisesOf(options.noises);
  const std::vector<PointSpread> psfs = psfsOf(options.psfs);
  Parameters params = options.settings.parameters();
  params.segmentation.keep = KeepComponents::Largest;
  StagedFolder folder(options.output, {"surface.md", "surface.json", "surface.csv"}, options.force);
  std::vector<SurfaceCase> cases;
  const auto all = static_cast<double>(shapes.size() * noises.size() * psfs.size());
  for (const PointSpread& psf : psfs)
    for (const SurfaceShape& shape : shapes) {
      std::optional<double> withoutNoise;
      for (const double noise : noises) {
        SurfaceShape one = shape;
        one.phantom.psf = psf;
        one.phantom.noiseSigma = noise;
        const auto n = static_cast<double>(cases.size());
        cases.push_back(runSurfaceCase(one, params, progress.sub(n / all, (n + 1.0) / all)));
        const auto triangles = static_cast<double>(cases.back().exported.quality.triangles);
        if (noise == 0.0 && triangles > 0.0) withoutNoise = triangles;
        if (noise > 0.0 && withoutNoise && triangles > 0.0)
          cases.back().trianglesAgainstNoNoise = triangles / *withoutNoise;
      }
    }
  Json json{{"schema", 1},
            {"seed", options.seed},
            {"parameters", Json::parse(parametersToJson(params))},
            {"cases", Json::array()}};
  for (const SurfaceCase& c : cases) json["cases"].push_back(jsonOf(c));
  const std::string table = markdown(cases, options);
  folder.add("surface.md", [&](const auto& place) { writeText(place, table); });
  folder.add("surface.json", [&](const auto& place) { writeText(place, json.dump(2) + "\n"); });
  folder.add("surface.csv", [&](const auto& place) { writeText(place, csv(cases)); });
  folder.commit();
  std::printf("%s", table.c_str());
  return Done;
}

}  // namespace

void addStudySurface(CLI::App& study, Session& session) {
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* command = study.add_subcommand(
      "surface", "The exported wall against the true one, on shapes, noises and point spreads");
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  command->add_option(
      "--shapes", options->shapes,
      "NAME,NAME: " + joined(surfaceShapes(1), ", ", &SurfaceShape::name) + "; all unless given");
  command->add_option("--noise", options->noises, "Sigmas of the noise, of 255")
      ->capture_default_str();
  command->add_option("--psf", options->psfs, "Point spreads, as of `phantom`")
      ->capture_default_str();
  command->add_option("--random-seed", options->seed, "Other trees, places and directions")
      ->capture_default_str();
  command->add_flag("--force", options->force, "Replace the tables of a former call");
  addSettings(*command, options->settings);
  setAction(command, session, options, surface);
}

}  // namespace angiomesh::cli

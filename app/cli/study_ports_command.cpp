// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/study_panel_command.h"
#include "app/session/options.h"
#include "app/study/study_ports.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/phantom/phantom.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/scan/image_io.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNoise = 20.0;

struct PortsOptions {
  ParameterOptions settings;
  std::vector<std::string> images;
  std::string output;
  int size = 96, cases = 20;
  bool force = false;
};

struct StudyVolume {
  std::string name;
  Source source;
};

/// The phantoms that the bars are for, or what is given.
std::vector<StudyVolume> volumesOf(const PortsOptions& options) {
  std::vector<StudyVolume> volumes;
  for (const std::string& image : options.images) {
    LoadedImage loaded = readImage(image, {});
    printWarnings(loaded.info);
    volumes.push_back({"image-" + std::to_string(volumes.size() + 1),
                       makeSource(std::move(loaded.image), "input")});
  }
  if (!volumes.empty()) return volumes;
  for (const char* kind : {"tube", "bifurcation", "aneurysm", "tree"}) {
    PhantomParams params;
    params.psf.kind = PointSpread::Kind::Subvoxels;
    params.kind = phantomKindFromName(kind);
    params.size = {options.size, options.size, options.size};
    params.radius = options.size / 24.0;
    params.axis = {0.21, -0.13, 1.0};
    params.noiseSigma = kNoise;
    volumes.push_back({kind, makeSource(makePhantom(params).image, "input")});
  }
  return volumes;
}

std::string fileOf(const std::string& name, int number) {
  return name + formatted("-%02d.stl", number + 1);
}

Json jsonOf(const PortCase& made) {
  return {{"cut", made.cut},
          {"refused_before", made.refused},
          {"triangles", made.triangles},
          {"off_plane_mm", made.offPlaneMm},
          {"area_error_percent", made.areaErrorPercent},
          {"area_spread_percent", made.spreadPercent},
          {"min_angle_deg", made.minAngle},
          {"self_intersections", made.intersections},
          {"unverified", made.unverified},
          {"leaks", made.leaks},
          {"name_faults", made.nameFaults}};
}

constexpr const char* kHead =
    "| volume | cuts | refused | off the plane, mm | area, % off | spread over rho, % | smallest "
    "angle | without cut | intersections | unverified | leaks | name faults |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string rowOf(const std::string& name, const std::vector<PortCase>& cases, double uncutAngle) {
  PortCase worst;
  worst.minAngle = 180.0;
  for (const PortCase& c : cases) {
    worst.refused += c.refused;
    worst.offPlaneMm = std::max(worst.offPlaneMm, c.offPlaneMm);
    worst.areaErrorPercent = std::max(worst.areaErrorPercent, std::fabs(c.areaErrorPercent));
    worst.spreadPercent = std::max(worst.spreadPercent, c.spreadPercent);
    worst.minAngle = std::min(worst.minAngle, c.minAngle);
    worst.intersections += c.intersections;
    worst.unverified += c.unverified;
    worst.leaks += c.leaks;
    worst.nameFaults += c.nameFaults;
  }
  return formatted("| %s | %zu | %d | %.1e | %.3f | %.3f | %.1f | %.1f | %zu | %zu | %zu | %zu |\n",
                   name.c_str(), cases.size(), worst.refused, worst.offPlaneMm,
                   worst.areaErrorPercent, worst.spreadPercent, worst.minAngle, uncutAngle,
                   worst.intersections, worst.unverified, worst.leaks, worst.nameFaults);
}

int ports(const PortsOptions& options, const Progress& progress) {
  const std::vector<StudyVolume> volumes = volumesOf(options);
  std::vector<std::string> names{"ports.json", "ports.md"};
  for (const StudyVolume& volume : volumes)
    for (int n = 0; n < options.cases; ++n) names.push_back(fileOf(volume.name, n));
  StagedFolder folder(options.output, names, options.force);
  Json json{{"schema", 1}, {"volumes", Json::array()}};
  std::string table = kHead;
  const Parameters params = options.settings.parameters();
  const auto steps = static_cast<double>(options.cases + 1);
  for (std::size_t v = 0; v < volumes.size(); ++v) {
    const Progress part =
        progress.sub(static_cast<double>(v) / static_cast<double>(volumes.size()),
                     static_cast<double>(v + 1) / static_cast<double>(volumes.size()));
    PortStudy study(volumes[v].source, params, part.sub(0.0, 1.0 / steps));
    std::vector<PortCase> cases;
    Json list = Json::array();
    for (int n = 0; n < options.cases; ++n) {
      const Progress one = part.sub((n + 1) / steps, (n + 2) / steps);
      folder.add(fileOf(volumes[v].name, n),
                 [&](const auto& place) { cases.push_back(study.run(1 + v, n, place, one)); });
      list.push_back(jsonOf(cases.back()));
    }
    const std::string row = rowOf(volumes[v].name, cases, study.uncutMinAngle());
    table += row;
    json["volumes"].push_back(
        {{"name", volumes[v].name}, {"refusals", study.refusals()}, {"cases", std::move(list)}});
  }
  folder.add("ports.json", [&](const auto& place) { writeText(place, json.dump(2) + "\n"); });
  folder.add("ports.md", [&](const auto& place) { writeText(place, table); });
  folder.commit();
  std::printf("%s", table.c_str());
  return Done;
}

}  // namespace

void addStudyPorts(CLI::App& study, Session& session) {
  auto options = std::make_shared<PortsOptions>();
  CLI::App* command = study.add_subcommand(
      "ports",
      "Cuts at random places of segmented phantoms or images: how true the openings are, and that "
      "they stay; with each surface as text STL");
  command
      ->add_option("--image", options->images,
                   "Image file or DICOM folder instead of the phantoms; may be repeated")
      ->allow_extra_args(false);
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  command->add_option("--cases", options->cases, "Cuts in each")
      ->check(CLI::Range(1, 99))
      ->capture_default_str();
  command->add_option("--size", options->size, "Voxels along each side of the phantoms")
      ->check(CLI::Range(48, 512))
      ->capture_default_str();
  addSettings(*command, options->settings);
  command->add_flag("--force", options->force, "Replace the results of a former call");
  setAction(command, session, options, ports);
}

}  // namespace angiomesh::cli

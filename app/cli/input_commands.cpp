// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/session/options.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/phantom/truth_json.h"
#include "io/dicom/dicom.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/scan/image_io.h"
#include "io/scan/label_image.h"
#include "io/volume/image_write.h"

namespace angiomesh::cli {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The findings of a DICOM series: without names of files in JSON, which may be kept.
Json findingsOf(const InputInfo& info) {
  Json list = Json::array();
  for (const Finding& finding : info.findings) {
    Json entry{{"kind", findingWord(finding.kind)}, {"text", finding.text}};
    if (!finding.slices.empty()) entry["slices"] = finding.slices;
    entry["usable"] = !finding.refuses;
    list.push_back(std::move(entry));
  }
  return list;
}

Json windowsOf(const InputInfo& info) {
  Json list = Json::array();
  for (const DisplayWindow& window : info.windows) {
    Json entry{{"width", window.width}, {"level", window.level}, {"function", window.function}};
    if (!window.name.empty()) entry["name"] = window.name;
    list.push_back(std::move(entry));
  }
  return list;
}

Json describe(const Geometry& g, const InputInfo& info) {
  const auto list = [](const auto& v) { return Json{v[0], v[1], v[2]}; };
  Json block{{"format", info.format}, {"pixel_type", info.pixelType}};
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty()) block[key] = value;
  };
  text("modality", info.modality);
  text("series_uid", info.seriesUid);
  text("series_description", info.seriesDescription);
  text("series_number", info.seriesNumber);
  text("date", info.date);
  text("orientation", info.orientation);
  block["files"] = info.files;
  block["size"] = g.size;
  block["spacing_mm"] = list(g.spacing);
  block["origin_mm"] = list(g.origin);
  for (int row = 0; row < 3; ++row) block["direction"].push_back(list(g.direction.row(row)));
  if (!info.windows.empty()) block["windows"] = windowsOf(info);
  if (!info.findings.empty()) block["findings"] = findingsOf(info);
  return block;
}

void printDescription(const Json& block) {
  const auto text = [&](const char* key) { return block.at(key).get<std::string>(); };
  const auto triple = [&](const Json& v) {
    std::printf("%.6g, %.6g, %.6g\n", v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
  };
  std::printf("format     %s, %s", text("format").c_str(), text("pixel_type").c_str());
  for (const char* key : {"modality", "orientation", "date"})
    if (block.contains(key)) std::printf(", %s", text(key).c_str());
  const int files = block.at("files").get<int>();
  if (files > 1) std::printf(", %d files", files);
  std::printf("\n");
  if (block.contains("series_uid")) std::printf("series     %s\n", text("series_uid").c_str());
  if (block.contains("series_number") || block.contains("series_description"))
    std::printf("           %s\n", (block.value("series_number", std::string()) + "  " +
                                    block.value("series_description", std::string()))
                                       .c_str());
  const Json& size = block.at("size");
  std::printf("size       %d x %d x %d voxels\n", size[0].get<int>(), size[1].get<int>(),
              size[2].get<int>());
  std::printf("spacing    ");
  triple(block.at("spacing_mm"));
  std::printf("origin     ");
  triple(block.at("origin_mm"));
  for (int row = 0; row < 3; ++row) {
    std::printf(row == 0 ? "direction  " : "           ");
    triple(block.at("direction")[static_cast<std::size_t>(row)]);
  }
  if (block.contains("range"))
    std::printf("range      %.6g .. %.6g\n", block["range"][0].get<double>(),
                block["range"][1].get<double>());
  for (const Json& window : block.value("windows", Json::array()))
    std::printf("window     %g, level %g  %s\n", window["width"].get<double>(),
                window["level"].get<double>(), window.value("name", std::string()).c_str());
  if (!block.contains("labels")) return;
  for (const Json& label : block["labels"])
    std::printf("label      %s, %zu voxels%s%s\n", label["value"].dump().c_str(),
                label["voxels"].get<std::size_t>(), label.contains("name") ? ", " : "",
                label.value("name", "").c_str());
}

struct InfoOptions {
  ReadOptions reading;
  std::string input;
  bool json = false;
};

void addLabels(Json& block, const std::vector<Label>& labels) {
  for (const Label& label : labels) {
    Json entry{{"value", label.value}, {"voxels", label.voxels}};
    if (!label.name.empty()) entry["name"] = label.name;
    block["labels"].push_back(entry);
  }
}

/// Of a segmentation in several layers, which is no single image.
Json describeLayers(const ImageSummary& entry, const std::string& path, const Progress& progress) {
  Json block = describe(entry.geometry, entry.info);
  const std::vector<Label> labels = readLabels(path, progress);
  std::int64_t greatest = 0;
  for (const Label& label : labels) greatest = std::max(greatest, label.value);
  block["range"] = {0, greatest};
  addLabels(block, labels);
  return block;
}

std::vector<ImageSummary> wantedEntries(const InfoOptions& options, const Progress& progress) {
  std::vector<ImageSummary> entries = describeImages(options.input, progress);
  std::vector<ImageSummary> wanted;
  for (ImageSummary& entry : entries)
    if (fitsSeries(entry.info.seriesUid, options.reading.series))
      wanted.push_back(std::move(entry));
  if (wanted.empty())
    throw InputError("no such series", options.input, "list the series without --series");
  return wanted;
}

int info(const InfoOptions& options, const Progress& progress) {
  const std::vector<ImageSummary> entries = wantedEntries(options, progress.sub(0.0, 0.4));
  std::vector<std::string> warnings = entries.front().info.warnings;
  std::vector<Json> blocks;
  for (const ImageSummary& entry : entries) blocks.push_back(describe(entry.geometry, entry.info));
  InputInfo single = entries.front().info;
  const bool readable =
      single.findings.empty() || options.reading.evenOut || entries.front().refusal() == nullptr;
  const bool ofDicom = entries.front().stack != nullptr;
  if (!ofDicom && segmentationLayers(options.input) > 1) {
    blocks.front() = describeLayers(entries.front(), options.input, progress.sub(0.4, 1.0));
  } else if (blocks.size() == 1 && readable) {
    const LoadedImage loaded =
        readImage(entries.front(), options.input, options.reading.evenOut, progress.sub(0.4, 0.9));
    single = loaded.info;
    warnings = single.warnings;
    blocks.front() = describe(loaded.image.geometry, loaded.info);
    const std::array<float, 2> range = valueRange(loaded.image);
    blocks.front()["range"] = {range[0], range[1]};
    if (!ofDicom)
      addLabels(blocks.front(), labelsOfSegmentation(options.input, loaded.image, progress));
  }
  if (options.json) {
    Json report{{"schema", 1}, {"warnings", warnings}};
    if (blocks.size() == 1)
      report["input"] = blocks.front();
    else
      report["series"] = blocks;
    std::printf("%s\n", report.dump(2).c_str());
    return Done;
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    printDescription(blocks[i]);
    const InputInfo& shown = blocks.size() == 1 ? single : entries[i].info;
    for (const Finding& finding : shown.findings)
      std::printf("%s %s: %s\n", finding.refuses ? "NO VOLUME " : "note      ",
                  findingWord(finding.kind).c_str(), screenText(finding).c_str());
    if (blocks.size() > 1) std::printf("\n");
  }
  for (const std::string& warning : warnings) printWarning(warning);
  return Done;
}

struct PhantomOptions {
  std::string kind, output, size = "128", spacing = "1,1,1", axis = "0,0,1", offset = "0,0,0";
  std::string radiusRange, noiseModel = "gaussian", psf = "gaussian:0.5";
  PhantomParams params;
  bool force = false;
};

std::vector<double> oneOrThree(const std::string& text, const std::string& option) {
  if (text.find(',') != std::string::npos) return parseNumbers(text, 3, option);
  return std::vector<double>(3, parseNumbers(text, 1, option)[0]);
}

Eigen::Vector3d vectorOf(const std::string& text, const std::string& option) {
  const std::vector<double> v = parseNumbers(text, 3, option);
  return {v[0], v[1], v[2]};
}

int phantom(PhantomOptions options, const Progress& progress) {
  constexpr double kLargest = 2048.0;
  PhantomParams& params = options.params;
  params.kind = phantomKindFromName(options.kind);
  const std::vector<double> size = oneOrThree(options.size, "--size");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (size[axis] != std::floor(size[axis]) || size[axis] < 8.0 || size[axis] > kLargest)
      throw InputError("'" + options.size + "' is not a number of voxels", "--size",
                       "give whole numbers from 8 to 2048");
    params.size[axis] = static_cast<int>(size[axis]);
  }
  const std::vector<double> spacing = oneOrThree(options.spacing, "--spacing");
  params.spacingMm = {spacing[0], spacing[1], spacing[2]};
  if (params.spacingMm.minCoeff() <= 0.0)
    throw InputError("'" + options.spacing + "' is not a spacing", "--spacing",
                     "give lengths above 0, in mm");
  params.axis = vectorOf(options.axis, "--axis");
  params.offset = vectorOf(options.offset, "--offset");
  if (!options.radiusRange.empty()) {
    const std::vector<double> range = parseNumbers(options.radiusRange, 2, "--radius-range");
    params.radiusMin = range[0];
    params.radiusMax = range[1];
  }
  params.psf = pointSpreadFromText(options.psf);
  params.noiseModel = options.noiseModel == "rician" ? NoiseModel::Rician : NoiseModel::Gaussian;
  // A former phantom is known by its truth.json; other images of these names are the user's.
  const bool former = fs::exists(fs::path(options.output) / "truth.json");
  StagedFolder folder(options.output, {"image.mha", "truth.mha", "truth.json", "clutter.mha"},
                      former || options.force);
  const Phantom made = makePhantom(params, progress.sub(0.0, 0.9));
  folder.add("image.mha", [&](const fs::path& place) { writeVolume(made.image, place); });
  progress.report(0.95);
  folder.add("truth.mha", [&](const fs::path& place) { writeVolume(made.truth, place); });
  if (params.clutter)
    folder.add("clutter.mha", [&](const fs::path& place) { writeVolume(made.clutter, place); });
  folder.add("truth.json",
             [&](const fs::path& place) { writeText(place, truthJson(params, made)); });
  progress.report(1.0);
  folder.commit();
  std::printf("%s: image.mha, truth.mha, truth.json%s\n", options.output.c_str(),
              params.clutter ? ", clutter.mha" : "");
  return Done;
}

}  // namespace

void addInfo(CLI::App& program, Session& session) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Geometry, range and series of an input");
  command->add_option("INPUT", options->input, "Image file or DICOM folder")->required();
  addReading(*command, options->reading);
  command->add_flag("--json", options->json, "Print JSON");
  setAction(command, session, options, info);
}

void addPhantom(CLI::App& program, Session& session) {
  auto options = std::make_shared<PhantomOptions>();
  PhantomParams& params = options->params;
  CLI::App* command =
      program.add_subcommand("phantom", "Make a synthetic image whose truth is known");
  command->add_option("KIND", options->kind, joined(phantomKindNames()))->required();
  command->add_option("-o,--output", options->output, "Folder to write")->required();
  command->add_option("--size", options->size, "Voxels: N or x,y,z");
  command->add_option("--spacing", options->spacing, "mm: one length or x,y,z");
  command->add_option("--random-seed", params.randomSeed, "Of the noise and of the tree");
  command->add_option("--terminals", params.terminals, "tree: number of terminal vessels")
      ->check(CLI::Range(1, 100000));
  command->add_option("--radius", params.radius, "Vessel radius in voxels");
  command->add_option("--radius-range", options->radiusRange, "tree: radii a,b in voxels");
  command->add_option("--gap", params.gap, "kissing: distance of the walls in voxels");
  command->add_option("--stenosis", params.stenosisPercent,
                      "stenosis: narrowing in percent of the diameter, 50 unless given");
  command->add_option("--psf", options->psf,
                      "Point spread: gaussian:SIGMA (voxels of the smallest spacing, 0.5 unless "
                      "given), mr or mr:ZEROFILLING (an MR acquisition), or subvoxels (2x2x2, as "
                      "in the literature)");
  command->add_option("--noise", params.noiseSigma, "Sigma of the noise, of 255")
      ->check(CLI::Range(0.0, 10000.0));
  command->add_option("--noise-model", options->noiseModel, "gaussian or rician")
      ->check(CLI::IsMember({"gaussian", "rician"}));
  command
      ->add_option("--drift", params.driftPercent,
                   "Smooth change of the intensity across the volume, +- percent")
      ->check(CLI::Range(0.0, 95.0));
  command
      ->add_option("--fade", params.fadePercent,
                   "Percent of the brightness that is left at the vessels' distal ends")
      ->check(CLI::Range(1.0, 100.0));
  command->add_flag("--clutter", params.clutter,
                    "Add what is bright and no vessel: a shell, a plate, blobs, bone, a vein and "
                    "steps between slabs");
  command->add_option("--axis", options->axis, "Direction x,y,z of the vessel, index axes");
  command->add_option("--offset", options->offset, "Shift x,y,z of the vessel in voxels");
  command->add_flag("--force", options->force, "Replace files of other origin");
  setAction(command, session, options, phantom);
}

}  // namespace angiomesh::cli

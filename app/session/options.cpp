// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/options.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "app/session/session.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "io/file/files.h"
#include "io/vessel/ports_file.h"

namespace angiomesh::cli {
namespace {

constexpr std::array<std::string_view, 8> kNumberOptions{
    "--seed", "--roi", "--size", "--cut", "--spacing", "--axis", "--offset", "--name-port"};

}  // namespace

std::vector<double> parseNumbers(const std::string& text, std::size_t count,
                                 const std::string& option) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  while (true) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at || !std::isfinite(number)) break;
    numbers.push_back(number);
    at = end;
    if (*at != ',') break;
    ++at;
  }
  if (*at != '\0' || numbers.size() != count)
    throw InputError("'" + text + "' is not " + std::to_string(count) + " numbers", option,
                     "separate them by commas, without spaces");
  return numbers;
}

Recipe ParameterOptions::recipe() const {
  Recipe recipe;
  Parameters& params = recipe.params = preset(presetName);
  if (!recipeFile.empty()) recipe = readRecipe(recipeFile, params);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw InputError("'" + setting + "' has no '='", "--set", "write --set key=value");
    setFieldFromText(params, std::string_view(setting).substr(0, equals),
                     std::string_view(setting).substr(equals + 1));
  }
  std::vector<double> points = params.seeds.points;
  for (const std::string& seed : seeds) {
    const std::vector<double> point = parseNumbers(seed, 3, "--seed");
    points.insert(points.end(), point.begin(), point.end());
  }
  if (!seeds.empty()) setField(params, "seeds.points", points);
  if (!roi.empty()) setField(params, "preprocess.roi", parseNumbers(roi, 6, "--roi"));
  if (!portsFile.empty()) addPorts(readPorts(portsFile), params.ports);
  params.ports.cuts.insert(params.ports.cuts.end(), cuts.begin(), cuts.end());
  if (!cutEnds.empty()) setFieldFromText(params, "ports.cutEndsRadii", cutEnds);
  if (cutBorders) params.ports.cutBorders = true;
  params.ports.names.insert(params.ports.names.end(), portNames.begin(), portNames.end());
  validate(params);
  return recipe;
}

void addSettings(CLI::App& command, ParameterOptions& options) {
  command.add_option("--preset", options.presetName,
                     "Parameters to start from: " + joined(presetNames()));
  command.add_option("--recipe,--params", options.recipeFile,
                     "The recipe.json of a run or an exported one, or a JSON file of parameters");
  command
      .add_option("--set", options.settings,
                  "One parameter as key=value; may be repeated ('angiomesh-cli parameters' lists "
                  "all)")
      ->allow_extra_args(false);
}

void addPlaces(CLI::App& command, ParameterOptions& options) {
  command.add_option("--seed", options.seeds, "A seed x,y,z in mm LPS; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--roi", options.roi, "Region of interest x0,y0,z0,x1,y1,z1 in mm LPS");
}

void addCuts(CLI::App& command, ParameterOptions& options) {
  command.add_option("--ports", options.portsFile,
                     "The ports.json of a run: its cuts once more, and the names that it gave to "
                     "openings at the border, by their places");
  command
      .add_option("--cut", options.cuts,
                  "A plane that ends a vessel, and the name of the opening: x,y,z,NAME or "
                  "x,y,z,nx,ny,nz,NAME in mm LPS, the normal pointing outwards; may be repeated")
      ->allow_extra_args(false);
  command.add_option(
      "--cut-ends", options.cutEnds,
      "Cut every vessel that ends in the volume so many of its radii before its tip");
  command.add_flag("--cut-borders", options.cutBorders,
                   "Cut vessels that the volume's border slices across just inside");
  command
      .add_option("--name-port", options.portNames,
                  "border_1=NAME, or x,y,z=NAME with the port's centre in mm LPS: call a port so; "
                  "may be repeated")
      ->allow_extra_args(false);
}

std::vector<std::string> joinNumbers(int argc, char** argv) {
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    const bool takesNumbers =
        std::find(kNumberOptions.begin(), kNumberOptions.end(), argument) != kNumberOptions.end();
    if (takesNumbers && i + 1 < argc) argument += std::string("=") + argv[++i];
    arguments.push_back(std::move(argument));
  }
  return arguments;
}

void addReading(CLI::App& command, ReadOptions& options) {
  options.replaceNotFinite = true;
  command.add_option("--series", options.series,
                     "Of a DICOM folder: the UID of a series, or the end of it");
  command
      .add_option_function<std::string>(
          "--uneven-slices",
          [&options](const std::string& text) { options.evenOut = text == "resample"; },
          "Where DICOM slices are missing or uneven: stop, or resample them to an even distance")
      ->check(CLI::IsMember({"stop", "resample"}))
      ->default_str("stop");
}

void printWarnings(const InputInfo& info) {
  for (const std::string& warning : screenWarnings(info)) printWarning(warning);
}

void checkOutputFile(const std::filesystem::path& file) {
  const std::filesystem::path folder = folderOf(file);
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw IoError("there is no such folder", folder.string(),
                  "make it first, or choose another place with -o");
  if (access(folder.c_str(), W_OK) != 0)
    throw IoError("the folder may not be written to", folder.string(),
                  "choose another place with -o");
}

}  // namespace angiomesh::cli

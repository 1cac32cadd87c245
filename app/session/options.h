// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/parameters/parameters.h"
#include "io/recipe/recipe_file.h"
#include "io/scan/image_io.h"

namespace angiomesh::cli {

/// "1,-2.5,3" as exactly `count` finite numbers. @throws InputError naming `option`
std::vector<double> parseNumbers(const std::string& text, std::size_t count,
                                 const std::string& option);

/// --preset, --recipe, --set, --seed, --roi, --ports, --cut, --cut-ends, --cut-borders and
/// --name-port.
struct ParameterOptions {
  std::string presetName = "angiomesh";
  std::string recipeFile;
  std::vector<std::string> settings;
  std::vector<std::string> seeds;
  std::string roi;
  std::string portsFile;
  std::vector<std::string> cuts;
  std::string cutEnds;
  std::vector<std::string> portNames;
  bool cutBorders = false;

  /// The recipe's, with the parameters of the preset, then of the file, then of --set, --seed,
  /// --roi and the cuts, checked. @throws InputError, IoError
  [[nodiscard]] Recipe recipe() const;
  [[nodiscard]] Parameters parameters() const { return recipe().params; }
};

/// Adds --preset, --recipe (or --params) and --set to a command.
void addSettings(CLI::App& command, ParameterOptions& options);

/// Adds --ports, --cut, --cut-ends, --cut-borders and --name-port to a command that makes a
/// surface.
void addCuts(CLI::App& command, ParameterOptions& options);

/// Adds --seed and --roi to a command that starts from an image.
void addPlaces(CLI::App& command, ParameterOptions& options);

/// "--seed -1,2,3" as "--seed=-1,2,3", so that numbers with a minus are not taken for options.
std::vector<std::string> joinNumbers(int argc, char** argv);

/// Adds --series and --uneven-slices.
void addReading(CLI::App& command, ReadOptions& options);

/// Prints what reading had to say, with the names of files.
void printWarnings(const InputInfo& info);

/// Finds out early, before a long computation, that a file cannot be written.
/// @throws IoError when its folder does not exist or may not be written to
void checkOutputFile(const std::filesystem::path& file);

}  // namespace angiomesh::cli

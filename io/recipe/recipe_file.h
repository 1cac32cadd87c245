// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters/presets.h"
#include "core/pipeline/source.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// What a recipe says of the volume that it was made for: enough to know it again. Never a name, a
/// path or anything else that may tell the patient.
struct RecipeSource {
  std::string hash;  ///< Source::hash
  Index3 size{0, 0, 0};
  Eigen::Vector3d spacingMm{1.0, 1.0, 1.0};
};

/// All that a result depends on beside the volume itself: parameters, with seeds, region of
/// interest, cuts, names of ports and parts left out among them, and the version of the program.
struct Recipe {
  Parameters params;
  std::string program;                 ///< the version that wrote it; empty: parameters alone
  std::optional<RecipeSource> source;  ///< empty: parameters alone
  std::string name, about;             ///< of a preset, see Preset; no name: it is none
};

/// The recipe of a case, in this version. @param evolve the evolution that these parameters led to,
/// where it is at hand: one that was ended by hand is ended there by levelset.stopAfter
Recipe recipeOf(const Parameters& params, const Source& source,
                const EvolveResult* evolve = nullptr);

/// Of a preset, which is for any volume, in this version.
Recipe recipeOf(const Preset& preset);

/// The parameters of any recipe without its places. One that has no name is called as its file.
Preset presetOf(const Recipe& recipe, const std::filesystem::path& file);

/// As a file holds it: JSON, schema 1, all parameters.
std::string recipeText(const Recipe& recipe);

/// textHash() of recipeText(): the same for the same parameters, volume and version.
std::string recipeHash(const Recipe& recipe);

/// Reads recipeText(), or an object of parameters alone; those that it does not name are as in
/// `base`. @param file named in errors
/// @throws IoError: no JSON   @throws InputError that names the value: unknown, missing, of the
/// wrong type or out of range; a newer schema
Recipe recipeFromText(std::string_view text, const Parameters& base, const std::string& file);

/// As recipeFromText(). @throws IoError also where the file cannot be read
Recipe readRecipe(const std::filesystem::path& file, const Parameters& base);

/// What is to be said where `source` is not what the recipe was made for, or was made for by
/// another version. @throws InputError: places among its parameters lie outside another volume
std::vector<std::string> recipeWarnings(const Recipe& recipe, const Source& source);

}  // namespace angiomesh

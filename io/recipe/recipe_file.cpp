// SPDX-License-Identifier: BSD-3-Clause
#include "io/recipe/recipe_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/base/json_text.h"
#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "io/file/files.h"
#include "io/file/json_place.h"

namespace angiomesh {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr std::size_t kHashDigits = 16;
/// A port's centre may lie on the border of a volume, and a cut beside the wall of its vessel.
constexpr double kBesideVoxels = 2.0;

std::string hashIn(const Json& value, const JsonPlace& place) {
  std::string hash = textIn(value, place);
  if (hash.size() != kHashDigits || hash.find_first_not_of("0123456789abcdef") != std::string::npos)
    place.refuse("is no hash of 16 digits from 0 to f");
  return hash;
}

RecipeSource sourceIn(const Json& json, const JsonPlace& place) {
  const std::vector<Json> values = valuesOf(json, {"hash", "size", "spacingMm"}, place);
  RecipeSource source;
  source.hash = hashIn(values[0], place.in("hash"));
  const std::vector<Json> size = threeIn(values[1], place.in("size"));
  const std::vector<Json> spacing = threeIn(values[2], place.in("spacingMm"));
  for (std::size_t a = 0; a < 3; ++a) {
    try {
      source.size[a] = countIn(size[a]);
    } catch (const std::out_of_range&) {
      place.in("size").at(a).refuse("is no count of voxels");
    }
    const JsonPlace at = place.in("spacingMm").at(a);
    const double mm = numberIn(spacing[a], at);
    if (!(mm > 0.0)) at.refuse("is not above 0");
    source.spacingMm[static_cast<Eigen::Index>(a)] = mm;
  }
  return source;
}

/// "legs" of "legs.recipe.json".
std::string baseNameOf(std::string file) {
  for (const std::string_view ending : {".json", ".recipe", ".preset"})
    if (file.size() > ending.size() && file.ends_with(ending))
      file.resize(file.size() - ending.size());
  return file;
}

void readName(const Json& json, const JsonPlace& place, Recipe& recipe) {
  const std::vector<Json> values = valuesOf(json, {"name", "about"}, place);
  recipe.name = textIn(values[0], place.in("name"));
  recipe.about = textIn(values[1], place.in("about"));
  if (recipe.name.empty()) place.in("name").refuse("is empty");
}

std::string gridText(const RecipeSource& source) {
  return formatted("%d x %d x %d voxels of %.4g x %.4g x %.4g mm", source.size[0], source.size[1],
                   source.size[2], source.spacingMm[0], source.spacingMm[1], source.spacingMm[2]);
}

/// The points among the values of a field that means places; of a box there are none.
std::vector<Eigen::Vector3d> pointsOf(const Field& field, const Parameters& params) {
  std::vector<Eigen::Vector3d> points;
  const FieldValue value = field.get(params);
  if (const auto* numbers = std::get_if<std::vector<double>>(&value); numbers && field.groupOf == 3)
    for (std::size_t n = 0; n + 2 < numbers->size(); n += 3)
      points.emplace_back((*numbers)[n], (*numbers)[n + 1], (*numbers)[n + 2]);
  if (field.key == "ports.cuts")
    for (const std::string& cut : params.ports.cuts) points.push_back(parseCut(cut).pointLps);
  if (field.key == "segmentation.corrections")
    // A line may be painted beyond the border.
    for (const std::string& text : params.segmentation.corrections)
      points.push_back(parseCorrection(text).placesLps.front());
  if (field.key == "ports.names")
    for (const std::string& name : params.ports.names)
      if (const auto place = parsePortNaming(name).placeLps) points.push_back(*place);
  return points;
}

/// Of another volume than the recipe's: what lies in it stays where it is.
void checkPlaces(const Parameters& params, const Geometry& grid) {
  for (const Field& field : parameterFields()) {
    if (!field.place) continue;
    const std::vector<Eigen::Vector3d> points = pointsOf(field, params);
    const auto outside = std::find_if(
        points.begin(), points.end(),
        [&](const Eigen::Vector3d& point) { return !grid.holds(point, kBesideVoxels); });
    if (outside != points.end())
      throw InputError("the recipe is of another volume, and its place at " + placeText(*outside) +
                           " lies outside this one",
                       field.key,
                       "leave such places out with --set " + field.key + "=none, or set them anew");
  }
}

}  // namespace

Recipe recipeOf(const Parameters& params, const Source& source, const EvolveResult* evolve) {
  Recipe recipe;
  recipe.params = params;
  if (evolve != nullptr && endedByHand(*evolve, params))
    recipe.params.levelset.stopAfter = evolve->iterations;
  recipe.program = versionText();
  const Geometry& grid = source.image->geometry;
  recipe.source = RecipeSource{source.hash, grid.size, grid.spacing};
  return recipe;
}

Recipe recipeOf(const Preset& preset) {
  Recipe recipe;
  recipe.params = preset.params;
  recipe.program = versionText();
  recipe.name = preset.name;
  recipe.about = preset.about;
  return recipe;
}

Preset presetOf(const Recipe& recipe, const std::filesystem::path& file) {
  Preset preset{recipe.name, recipe.about, recipe.params};
  if (preset.name.empty()) preset.name = baseNameOf(file.filename().string());
  copyPlaces(Parameters(), preset.params);
  return preset;
}

std::string recipeText(const Recipe& recipe) {
  Json json = {{"schema", kSchema}, {"program", recipe.program}};
  if (!recipe.name.empty()) json["preset"] = {{"name", recipe.name}, {"about", recipe.about}};
  if (recipe.source) {
    const RecipeSource& source = *recipe.source;
    const Eigen::Vector3d& mm = source.spacingMm;
    json["source"] = {
        {"hash", source.hash}, {"size", source.size}, {"spacingMm", {mm.x(), mm.y(), mm.z()}}};
  }
  json["parameters"] = Json::parse(parametersToJson(recipe.params));
  return json.dump(2) + "\n";
}

std::string recipeHash(const Recipe& recipe) { return textHash(recipeText(recipe)); }

Recipe recipeFromText(std::string_view text, const Parameters& base, const std::string& file) {
  const Json json = parseJson<Json>(text);
  if (json.is_discarded()) throw IoError("the file is no JSON", file, kCopyAgain);
  Recipe recipe;
  if (!json.is_object() || (!json.contains("schema") && !json.contains("parameters"))) {
    recipe.params = parametersFromJson(text, base, file);
    return recipe;
  }
  const JsonPlace root(file);
  checkSchema(json.value("schema", Json()), kSchema, "the recipe was", file);
  std::vector<std::string> keys{"schema", "program", "parameters"};
  for (const char* key : {"source", "preset"})
    if (json.contains(key)) keys.emplace_back(key);
  const std::vector<Json> values = valuesOf(json, keys, root);
  recipe.program = textIn(values[1], root.in("program"));
  if (!values[2].is_object()) root.in("parameters").refuse("is no object");
  recipe.params = parametersFromJson(values[2].dump(), base, file);
  if (json.contains("source")) recipe.source = sourceIn(json["source"], root.in("source"));
  if (json.contains("preset")) readName(json["preset"], root.in("preset"), recipe);
  return recipe;
}

Recipe readRecipe(const std::filesystem::path& file, const Parameters& base) {
  return recipeFromText(readText(file, kMostJsonBytes), base, file.string());
}

std::vector<std::string> recipeWarnings(const Recipe& recipe, const Source& source) {
  std::vector<std::string> warnings;
  if (!recipe.program.empty() && recipe.program != versionText())
    warnings.push_back("the recipe was written by version " + recipe.program + ", this is " +
                       versionText() + ": the result may be another one");
  if (recipe.source && recipe.source->hash != source.hash) {
    checkPlaces(recipe.params, source.image->geometry);
    warnings.push_back("the recipe was made for another volume, of " + gridText(*recipe.source) +
                       ": positions in it, if any, are taken as they are, in mm LPS");
  }
  return warnings;
}

}  // namespace angiomesh

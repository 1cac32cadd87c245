// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/case_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "io/case/case_journal.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/file/temporary_place.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const char* const kFile = "case.json";
const char* const kPrevious = "case.previous.json";

/// The file is no case.json that was written whole.
class Damaged : public IoError {
 public:
  explicit Damaged(const fs::path& file)
      : IoError("the case is damaged", file.string(),
                "open a copy of it, or open its volume and begin anew") {}
};

Json toJson(const Eigen::Vector3d& v) { return Json::array({v[0], v[1], v[2]}); }

Json toJson(const CaseSource& source) {
  const Geometry& g = source.grid;
  Json direction = Json::array();
  for (int row = 0; row < 3; ++row)
    direction.push_back(toJson(Eigen::Vector3d(g.direction.row(row).transpose())));
  return {{"hash", source.hash},   {"format", source.format},        {"files", source.files},
          {"size", g.size},        {"spacingMm", toJson(g.spacing)}, {"originMm", toJson(g.origin)},
          {"direction", direction}};
}

Json toJson(const CaseView& view) {
  Json slabs = Json::object();
  for (const auto& [pane, slab] : view.slabs)
    slabs[pane] = {{"mode", slab.mode}, {"thicknessMm", slab.thicknessMm}};
  Json json = {{"layer", view.layer}, {"windowLevels", view.windowLevels},
               {"slabs", slabs},      {"shown", view.shown},
               {"mesh", view.mesh},   {"colour", view.colour}};
  if (!view.overlay.empty()) {
    json["overlay"] = view.overlay;
    json["overlayOpacity"] = view.overlayOpacity;
  }
  if (view.planes)
    json["planes"] = {{"patientAxes", view.planes->patientAxes},
                      {"turns", view.planes->turns},
                      {"pivotMm", view.planes->pivotMm}};
  if (view.crosshairLps) json["crosshairMm"] = toJson(*view.crosshairLps);
  return json;
}

Eigen::Vector3d vectorFrom(const Json& json) {
  const auto numbers = json.get<std::array<double, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

CaseSource sourceFrom(const Json& json) {
  CaseSource source;
  source.hash = json.at("hash").get<std::string>();
  source.format = json.at("format").get<std::string>();
  source.files = countIn(json.at("files"));
  for (std::size_t a = 0; a < 3; ++a) source.grid.size[a] = countIn(json.at("size").at(a));
  source.grid.spacing = vectorFrom(json.at("spacingMm"));
  source.grid.origin = vectorFrom(json.at("originMm"));
  for (int row = 0; row < 3; ++row)
    source.grid.direction.row(row) =
        vectorFrom(json.at("direction").at(static_cast<std::size_t>(row))).transpose();
  return source;
}

template <class T>
void take(T& value, const Json& json, const char* key) {
  if (json.contains(key)) value = json.at(key).get<T>();
}

std::map<std::string, CaseSlab> slabsFrom(const Json& json) {
  std::map<std::string, CaseSlab> slabs;
  if (json.contains("slabs")) {
    for (const auto& [pane, slab] : json.at("slabs").items())
      slabs[pane] = {slab.at("mode").get<std::string>(), slab.at("thicknessMm").get<double>()};
    return slabs;
  }
  // Cases of version 0.2 have one for all panes.
  CaseSlab all;
  take(all.mode, json, "slab");
  take(all.thicknessMm, json, "slabThicknessMm");
  if (!all.mode.empty()) slabs = {{"sagittal", all}, {"coronal", all}, {"axial", all}};
  return slabs;
}

CaseView viewFrom(const Json& json) {
  CaseView view;
  take(view.layer, json, "layer");
  take(view.windowLevels, json, "windowLevels");
  view.slabs = slabsFrom(json);
  take(view.shown, json, "shown");
  take(view.mesh, json, "mesh");
  take(view.colour, json, "colour");
  take(view.overlay, json, "overlay");
  take(view.overlayOpacity, json, "overlayOpacity");
  if (json.contains("planes")) {
    const Json& planes = json.at("planes");
    view.planes.emplace();
    take(view.planes->patientAxes, planes, "patientAxes");
    take(view.planes->turns, planes, "turns");
    take(view.planes->pivotMm, planes, "pivotMm");
  }
  if (json.contains("crosshairMm")) view.crosshairLps = vectorFrom(json.at("crosshairMm"));
  return view;
}

bool isField(const std::string& key) {
  const auto& fields = parameterFields();
  return std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return f.key == key; });
}

/// Takes what is no parameter out of `object` and into `unknown`.
void dropUnknown(Json& object, const std::string& prefix, std::vector<std::string>& unknown) {
  for (auto entry = object.begin(); entry != object.end();) {
    const std::string key = prefix + entry.key();
    if (entry.value().is_object()) {
      dropUnknown(entry.value(), key + ".", unknown);
      ++entry;
    } else if (isField(key)) {
      ++entry;
    } else {
      unknown.push_back(key);
      entry = object.erase(entry);
    }
  }
}

/// Without the groups that dropUnknown() left empty, which need not be groups at all.
void dropEmpty(Json& object) {
  for (auto entry = object.begin(); entry != object.end();) {
    if (entry.value().is_object()) dropEmpty(entry.value());
    const bool empty = entry.value().is_object() && entry.value().empty();
    entry = empty ? object.erase(entry) : std::next(entry);
  }
}

/// The values of `object` one by one: what cannot be used keeps its value in `params`.
void takeUsable(Parameters& params, const Json& object, const std::vector<std::string>& groups,
                std::vector<std::string>& warnings) {
  for (const auto& [key, value] : object.items()) {
    std::vector<std::string> path = groups;
    path.push_back(key);
    if (value.is_object()) {
      takeUsable(params, value, path, warnings);
      continue;
    }
    Json one = value;
    for (auto name = path.rbegin(); name != path.rend(); ++name) one = Json{{*name, one}};
    try {
      params = parametersFromJson(one.dump(), params, "the case");
    } catch (const InputError& error) {
      warnings.push_back(std::string("a parameter of the case was left at its default: ") +
                         error.what());
    }
  }
}

Parameters parametersOf(const Json& json, const fs::path& file,
                        std::vector<std::string>& warnings) {
  Parameters params = preset("angiomesh");
  try {
    return parametersFromJson(json.dump(), params, file.string());
  } catch (const InputError&) {
    takeUsable(params, json, {}, warnings);
    return params;
  }
}

CaseReading parse(const std::string& text, const fs::path& file) {
  Json json = parseJson<Json>(text);
  if (!json.is_object() || !json.contains("schema") || !json["schema"].is_number_integer())
    throw Damaged(file);
  const auto schema = json["schema"].get<std::int64_t>();
  if (schema < 1) throw Damaged(file);
  if (schema > kCaseSchema)
    throw InputError("the case was written by a newer Angiomesh (schema " + std::to_string(schema) +
                         "; this one reads up to " + std::to_string(kCaseSchema) + ")",
                     file.parent_path().string(), "update the program");
  CaseReading reading;
  SavedCase& document = reading.document;
  Json parameters;
  try {
    document.source = sourceFrom(json.at("source"));
    document.saves = countIn(json.at("saves"));
    parameters = json.at("parameters");
    if (!parameters.is_object()) throw Damaged(file);
  } catch (const Json::exception&) {
    throw Damaged(file);
  } catch (const std::out_of_range&) {
    throw Damaged(file);
  }
  try {
    if (json.contains("view")) document.view = viewFrom(json["view"]);
  } catch (const Json::exception&) {
    reading.warnings.push_back("the case does not say what was shown: the view begins anew");
  }
  std::vector<std::string> unknown;
  dropUnknown(parameters, "", unknown);
  dropEmpty(parameters);
  for (const std::string& key : unknown)
    reading.warnings.push_back("the case has a parameter that this program does not know, " + key +
                               ": it was left out");
  document.params = parametersOf(parameters, file, reading.warnings);
  if (json.contains("notes"))
    document.notes = notesFromJson(json["notes"].dump(), reading.warnings);
  return reading;
}

std::string textOf(const SavedCase& document) {
  Json json = {{"schema", kCaseSchema},
               {"program", versionText()},
               {"saves", document.saves},
               {"source", toJson(document.source)},
               {"parameters", Json::parse(parametersToJson(document.params))},
               {"view", toJson(document.view)}};
  if (document.notes != CaseNotes()) json["notes"] = Json::parse(notesToJson(document.notes));
  return json.dump(2) + "\n";
}

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// A new folder appears with its case.json in it, by rename.
void makeCase(const fs::path& folder, const std::string& text) {
  const fs::path parent = folderOf(folder);
  std::error_code error;
  if (!fs::is_directory(parent, error))
    throw IoError("cannot write the case, there is no such folder", folder.string(),
                  "make the folder first or choose another place");
  removeLeftovers(parent);
  std::optional<TemporaryPlace> temporary;
  try {
    temporary.emplace(parent, TemporaryPlace::Kind::Folder);
  } catch (const fs::filesystem_error& failure) {
    throw IoError("cannot write the case (" + failure.code().message() + ")", folder.string(),
                  "check that the folder may be written to and has free space");
  }
  writeText(temporary->path() / kFile, text);
  error = renameNew(temporary->path(), folder);
  if (error)
    throw IoError("cannot write the case (" + error.message() + ")", folder.string(),
                  "choose another place");
  syncFolder(parent);
}

/// The case by its edits, where no save can be read.
std::optional<CaseReading> fromJournal(const fs::path& folder) {
  const std::vector<JournalStep> steps = readJournal(folder, 0);
  if (steps.empty()) return std::nullopt;
  CaseReading reading;
  reading.document.params = steps.back().params;
  reading.document.notes = steps.back().notes;
  reading.document.saves = steps.back().saves;
  reading.warnings.emplace_back(
      "case.json and case.previous.json are damaged: the parameters are those of the last edit in "
      "the journal");
  try {
    const Json source = parseJson<Json>(journalSource(folder));
    if (source.is_object()) reading.document.source = sourceFrom(source);
  } catch (const Json::exception&) {
    reading.document.source = {};
  } catch (const std::out_of_range&) {
    reading.document.source = {};
  }
  if (reading.document.source.hash.empty())
    reading.warnings.emplace_back("the case does not say any more which volume it was made of");
  return reading;
}

/// The case.json at hand becomes the previous one, unless it is damaged.
void keepPrevious(const fs::path& folder) {
  const fs::path file = placeIn(folder, kFile), previous = placeIn(folder, kPrevious);
  if (!isThere(file)) return;
  std::string text;
  try {
    text = readText(file, kMostJsonBytes);
    (void)parse(text, file);
  } catch (const Error&) {
    return;
  }
  writeText(previous, text);
}

/// What a program that was killed had begun to write in the case's folders.
void removeUnfinished(const fs::path& folder) {
  for (const char* name : {"", "cache", "edits"}) {
    try {
      removeLeftovers(placeIn(folder, name));
    } catch (const IoError&) {
      // A link to a place that is not the case's.
    }
  }
}

}  // namespace

bool isCase(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder, error) &&
         (folder.extension() == ".angiomesh" || isThere(folder / kFile) ||
          isThere(folder / kPrevious));
}

fs::path caseFolder(const fs::path& path) {
  std::error_code error;
  fs::path folder = path.has_filename() ? path : path.parent_path();
  if (folder.filename() == kFile && fs::is_regular_file(folder, error)) return folderOf(folder);
  return folder;
}

void writeCase(const fs::path& folder, const SavedCase& document) {
  const std::string text = textOf(document);
  std::error_code error;
  if (!fs::exists(folder, error)) {
    makeCase(folder, text);
    return;
  }
  if (!fs::is_directory(folder, error))
    throw IoError("cannot write the case, a file has this name", folder.string(),
                  "choose another name");
  if (!isThere(folder / kFile) && !isThere(folder / kPrevious) && !fs::is_empty(folder, error))
    throw IoError("cannot write the case, the folder holds other files", folder.string(),
                  "choose another name");
  const fs::path file = placeIn(folder, kFile);
  keepPrevious(folder);
  writeText(file, text);
}

CaseReading readCase(const fs::path& folder) {
  const fs::path file = placeIn(folder, kFile), previous = placeIn(folder, kPrevious);
  if (!isThere(file) && !isThere(previous))
    throw IoError("the folder holds no case", folder.string(),
                  "give a folder that Angiomesh saved, NAME.angiomesh");
  removeUnfinished(folder);
  try {
    return parse(readText(file, kMostJsonBytes), file);
  } catch (const IoError&) {
    // Then what was saved before.
  }
  try {
    if (isThere(previous)) {
      CaseReading reading = parse(readText(previous, kMostJsonBytes), previous);
      reading.warnings.insert(
          reading.warnings.begin(),
          "case.json is missing or damaged: the case is as it was one save before");
      return reading;
    }
  } catch (const IoError&) {
    // Then what was edited since.
  }
  if (std::optional<CaseReading> reading = fromJournal(folder)) return *std::move(reading);
  throw Damaged(file);
}

std::string caseSourceText(const fs::path& folder) {
  for (const char* name : {kFile, kPrevious}) {
    try {
      const fs::path file = placeIn(folder, name);
      return toJson(parse(readText(file, kMostJsonBytes), file).document.source).dump();
    } catch (const Error&) {
      continue;
    }
  }
  return {};
}

}  // namespace angiomesh

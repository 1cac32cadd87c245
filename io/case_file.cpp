// SPDX-License-Identifier: BSD-3-Clause
#include "io/case_file.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <random>
#include <system_error>

#include "core/base/error.h"
#include "core/pipeline/report.h"
#include "io/files.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const char* const kFile = "case.json";
const char* const kPrevious = "case.previous.json";
const char* const kTemporaryPrefix = ".angiomesh-";
constexpr std::chrono::hours kTemporaryAge{1};

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
  Json json = {{"layer", view.layer},  {"windowLevels", view.windowLevels},
               {"slab", view.slab},    {"slabThicknessMm", view.slabThicknessMm},
               {"shown", view.shown},  {"mesh", view.mesh},
               {"colour", view.colour}};
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
  source.files = json.at("files").get<int>();
  source.grid.size = json.at("size").get<Index3>();
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

CaseView viewFrom(const Json& json) {
  CaseView view;
  take(view.layer, json, "layer");
  take(view.windowLevels, json, "windowLevels");
  take(view.slab, json, "slab");
  take(view.slabThicknessMm, json, "slabThicknessMm");
  take(view.shown, json, "shown");
  take(view.mesh, json, "mesh");
  take(view.colour, json, "colour");
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

CaseReading parse(const std::string& text, const fs::path& file) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("schema") || !json["schema"].is_number_integer())
    throw Damaged(file);
  const int schema = json["schema"].get<int>();
  if (schema > kCaseSchema)
    throw InputError("the case was written by a newer Angiomesh (schema " + std::to_string(schema) +
                         "; this one reads up to " + std::to_string(kCaseSchema) + ")",
                     file.parent_path().string(), "update the program");
  CaseReading reading;
  CaseDocument& document = reading.document;
  Json parameters;
  try {
    document.source = sourceFrom(json.at("source"));
    document.saves = json.at("saves").get<int>();
    parameters = json.at("parameters");
    if (!parameters.is_object()) throw Damaged(file);
  } catch (const Json::exception&) {
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
  document.params = parametersFromJson(parameters.dump(), preset("angiomesh"), file.string());
  return reading;
}

std::string textOf(const CaseDocument& document) {
  const Json json = {{"schema", kCaseSchema},
                     {"program", versionText()},
                     {"saves", document.saves},
                     {"source", toJson(document.source)},
                     {"parameters", Json::parse(parametersToJson(document.params))},
                     {"view", toJson(document.view)}};
  return json.dump(2) + "\n";
}

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// A new folder appears with its case.json in it, by rename.
void makeCase(const fs::path& folder, const std::string& text) {
  static std::atomic<unsigned> counter{0};
  static const unsigned salt = std::random_device{}();
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(parent, error))
    throw IoError("cannot write the case, there is no such folder", folder.string(),
                  "make the folder first or choose another place");
  const fs::path temporary = parent / (kTemporaryPrefix + std::to_string(::getpid()) + "-" +
                                       std::to_string(salt) + "-" + std::to_string(counter++));
  fs::create_directory(temporary, error);
  if (error)
    throw IoError("cannot write the case (" + error.message() + ")", folder.string(),
                  "check that the folder may be written to and has free space");
  try {
    writeText(temporary / kFile, text);
    fs::rename(temporary, folder, error);
    if (error)
      throw IoError("cannot write the case (" + error.message() + ")", folder.string(),
                    "choose another place");
  } catch (...) {
    fs::remove_all(temporary, error);
    throw;
  }
}

/// The case.json at hand becomes the previous one, unless it is damaged.
void keepPrevious(const fs::path& folder) {
  const fs::path file = folder / kFile;
  if (!isThere(file)) return;
  std::string text;
  try {
    text = readText(file);
    (void)parse(text, file);
  } catch (const Error&) {
    return;
  }
  writeText(folder / kPrevious, text);
}

/// Half-written files of programs that were killed.
void removeOldTemporaries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!entry.path().filename().string().starts_with(kTemporaryPrefix)) continue;
    const auto written = entry.last_write_time(error);
    if (!error && fs::file_time_type::clock::now() - written > kTemporaryAge)
      old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove(path, error);
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
  if (folder.filename() == kFile && fs::is_regular_file(folder, error))
    return folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  return folder;
}

void writeCase(const fs::path& folder, const CaseDocument& document) {
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
  keepPrevious(folder);
  writeText(folder / kFile, text);
  removeOldTemporaries(folder);
}

CaseReading readCase(const fs::path& folder) {
  const fs::path file = folder / kFile;
  const fs::path previous = folder / kPrevious;
  if (!isThere(file) && !isThere(previous))
    throw IoError("the folder holds no case", folder.string(),
                  "give a folder that Angiomesh saved, NAME.angiomesh");
  try {
    return parse(readText(file), file);
  } catch (const IoError&) {
    if (!isThere(previous)) throw;
  }
  CaseReading reading = parse(readText(previous), previous);
  reading.warnings.insert(reading.warnings.begin(),
                          "case.json is missing or damaged: the case is as it was one save before");
  return reading;
}

}  // namespace angiomesh

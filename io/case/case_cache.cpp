// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/case_cache.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 3;

fs::path noteOf(const fs::path& folder) { return placeIn(folder, "cache/evolve.json"); }
fs::path phiOf(const fs::path& folder) { return placeIn(folder, "cache/evolve.nrrd"); }
fs::path voxelwiseOf(const fs::path& folder) { return placeIn(folder, "cache/voxelwise.nrrd"); }

/// Numbers that NRRD's text may round.
Json toJson(const Geometry& g) {
  Json json = Json::array();
  for (int a = 0; a < 3; ++a) {
    json.push_back(g.spacing[a]);
    json.push_back(g.origin[a]);
    for (int b = 0; b < 3; ++b) json.push_back(g.direction(a, b));
  }
  return json;
}

Geometry geometryFrom(const Json& json, const Index3& size) {
  Geometry g;
  g.size = size;
  std::size_t at = 0;
  for (int a = 0; a < 3; ++a) {
    g.spacing[a] = json.at(at++).get<double>();
    g.origin[a] = json.at(at++).get<double>();
    for (int b = 0; b < 3; ++b) g.direction(a, b) = json.at(at++).get<double>();
  }
  return g;
}

Json toJson(const CachedEvolve& evolve) {
  const EvolveResult& r = evolve.result;
  Json json = {{"format", kFormat},
               {"key", evolve.report.key},
               {"phi", contentHash(*r.phi)},
               {"geometry", toJson(r.phi->geometry)},
               {"a", r.thresholds.a},
               {"b", r.thresholds.b},
               {"vAverage", r.thresholds.vAverage},
               {"clamped", r.thresholds.clamped},
               {"iterations", r.iterations},
               {"converged", r.converged},
               {"stopReason", static_cast<int>(r.stopReason)},
               {"seconds", evolve.report.seconds},
               {"cpuSeconds", evolve.report.cpuSeconds},
               {"warnings", evolve.report.warnings}};
  if (r.lower) json["lower"] = *r.lower;
  if (r.upper) json["upper"] = *r.upper;
  if (r.label)
    json["label"] = {{"voxels", r.label->voxels},
                     {"largestShiftVoxels", r.label->largestShiftVoxels},
                     {"maskVolumeMm3", r.label->maskVolumeMm3},
                     {"joined", r.label->contacts.joined},
                     {"parted", r.label->contacts.parted},
                     {"left", r.label->contacts.left}};
  if (r.wall)
    json["wall"] = {{"spreadVoxels", r.wall->spreadVoxels},
                    {"heldVoxels", r.wall->heldVoxels},
                    {"filledHoles", r.wall->filledHoles},
                    {"cutHandles", r.wall->cutHandles}};
  if (r.voxelwise) json["voxelwise"] = contentHash(*r.voxelwise);
  return json;
}

CachedEvolve fromJson(const Json& json) {
  CachedEvolve evolve;
  EvolveResult& r = evolve.result;
  r.thresholds.a = json.at("a").get<double>();
  r.thresholds.b = json.at("b").get<double>();
  r.thresholds.vAverage = json.at("vAverage").get<double>();
  r.thresholds.clamped = json.at("clamped").get<bool>();
  r.iterations = countIn(json.at("iterations"));
  r.converged = json.at("converged").get<bool>();
  const int reason = countIn(json.at("stopReason"));
  if (reason > static_cast<int>(StopReason::Stopped)) throw std::out_of_range("no such reason");
  r.stopReason = static_cast<StopReason>(reason);
  if (json.contains("lower")) r.lower = json.at("lower").get<double>();
  if (json.contains("upper")) r.upper = json.at("upper").get<double>();
  if (json.contains("label")) {
    const Json& label = json.at("label");
    r.label = {label.at("voxels").get<std::size_t>(),
               label.at("largestShiftVoxels").get<double>(),
               label.at("maskVolumeMm3").get<double>(),
               {label.at("joined").get<std::size_t>(), label.at("parted").get<std::size_t>(),
                label.at("left").get<std::size_t>()}};
  }
  if (json.contains("wall")) {
    const Json& wall = json.at("wall");
    r.wall = {wall.at("spreadVoxels").get<double>(), wall.at("heldVoxels").get<std::size_t>(),
              wall.at("filledHoles").get<std::size_t>(), wall.at("cutHandles").get<std::size_t>()};
  }
  evolve.report.step = Step::Evolve;
  evolve.report.key = json.at("key").get<std::string>();
  evolve.report.seconds = json.at("seconds").get<double>();
  evolve.report.cpuSeconds = json.at("cpuSeconds").get<double>();
  evolve.report.warnings = json.at("warnings").get<std::vector<std::string>>();
  return evolve;
}

/// A volume of the cache. @throws InputError when it is not the one that the note tells of
std::shared_ptr<const Volume<float>> readVolume(const fs::path& path, const Json& note,
                                                const char* hash) {
  Volume<float> volume = readImage(path).image;
  volume.geometry = geometryFrom(note.at("geometry"), volume.geometry.size);
  if (contentHash(volume) != note.at(hash).get<std::string>())
    throw InputError("the cache holds another volume", path.filename().string(), "compute it anew");
  return std::make_shared<const Volume<float>>(std::move(volume));
}

/// The note of another format, or of none, is a null.
Json readNote(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(noteOf(folder), error)) return {};
  Json json = parseJson<Json>(readText(noteOf(folder), kMostJsonBytes));
  const bool ours = json.is_object() && json.contains("format") && json["format"] == kFormat &&
                    json.contains("key") && json["key"].is_string();
  return ours ? json : Json();
}

}  // namespace

void writeCache(const fs::path& folder, const CachedEvolve& evolve) {
  const Json note = readNote(folder);
  if (note.is_object() && note.at("key") == evolve.report.key) return;
  std::error_code error;
  fs::create_directory(folder / "cache", error);
  // Whatever happens in between, a note never goes with another volume than its own.
  fs::remove(noteOf(folder), error);
  writeVolume(*evolve.result.phi, phiOf(folder));
  if (evolve.result.voxelwise) writeVolume(*evolve.result.voxelwise, voxelwiseOf(folder));
  writeText(noteOf(folder), toJson(evolve).dump(2) + "\n");
}

std::optional<CachedEvolve> readCache(const fs::path& folder, const std::string& key) {
  try {
    const Json note = readNote(folder);
    if (!note.is_object() || note.at("key") != key) return std::nullopt;
    CachedEvolve evolve = fromJson(note);
    evolve.result.phi = readVolume(phiOf(folder), note, "phi");
    if (note.contains("voxelwise"))
      evolve.result.voxelwise = readVolume(voxelwiseOf(folder), note, "voxelwise");
    return evolve;
  } catch (const std::exception&) {
    // A cache that cannot be read is no cache.
    return std::nullopt;
  }
}

}  // namespace angiomesh

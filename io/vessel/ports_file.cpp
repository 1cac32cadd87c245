// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/ports_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/openings/port_json.h"
#include "io/file/files.h"
#include "io/file/json_place.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr double kTolerance = 1e-3;

Eigen::Vector3d vectorIn(const Json& value, const JsonPlace& place) {
  const std::vector<Json> three = threeIn(value, place);
  Eigen::Vector3d vector;
  for (std::size_t a = 0; a < 3; ++a) vector[static_cast<int>(a)] = numberIn(three[a], place.at(a));
  return vector;
}

void expect(const Json& value, const Json& wanted, const JsonPlace& place) {
  if (value != wanted) place.refuse("is not " + wanted.dump());
}

BorderSlant slantIn(const Json& json, const JsonPlace& place) {
  const std::vector<Json> values = valuesOf(
      json, {"angle_deg", "area_ratio", "section_area_mm2", "section_centre_mm", "axis"}, place);
  BorderSlant slant;
  slant.angleDeg = numberIn(values[0], place.in("angle_deg"));
  slant.areaRatio = numberIn(values[1], place.in("area_ratio"));
  slant.sectionAreaMm2 = numberIn(values[2], place.in("section_area_mm2"));
  slant.centreLps = vectorIn(values[3], place.in("section_centre_mm"));
  slant.axisLps = vectorIn(values[4], place.in("axis"));
  if (std::fabs(slant.axisLps.norm() - 1.0) > kTolerance)
    place.in("axis").refuse("is not of length 1");
  return slant;
}

bool isBorder(const Json& kind, const JsonPlace& place) {
  if (kind != kBorderKind && kind != kCutKind) place.refuse("is neither \"cut\" nor \"border\"");
  return kind == kBorderKind;
}

Port portIn(const Json& json, const JsonPlace& place) {
  std::vector<std::string> keys{"name", "centre_mm", "normal", "area_mm2",
                                "equivalent_diameter_mm"};
  const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
  const bool slanted = has("vessel");
  if (slanted) keys.emplace_back("vessel");
  if (has("kind")) keys.emplace_back("kind");
  const std::vector<Json> values = valuesOf(json, keys, place);
  Port port;
  port.name = textIn(values[0], place.in("name"));
  port.centreLps = vectorIn(values[1], place.in("centre_mm"));
  port.normalLps = vectorIn(values[2], place.in("normal"));
  port.areaMm2 = numberIn(values[3], place.in("area_mm2"));
  const double diameter = numberIn(values[4], place.in("equivalent_diameter_mm"));
  if (std::fabs(port.normalLps.norm() - 1.0) > kTolerance)
    place.in("normal").refuse("is not of length 1");
  if (port.areaMm2 < 0.0) place.in("area_mm2").refuse("is negative");
  if (std::fabs(diameter - port.equivalentDiameterMm()) > kTolerance * diameter)
    place.in("equivalent_diameter_mm").refuse("is not that of a circle of this area");
  if (slanted) port.slant = slantIn(values[5], place.in("vessel"));
  port.atBorder = slanted || port.name.starts_with(kBorderPrefix);
  if (has("kind")) port.atBorder = isBorder(values.back(), place.in("kind"));
  return port;
}

/// What is wrong with a name beside those before it, empty: nothing.
std::string nameFault(const std::string& name, std::set<std::string>& taken) {
  if (name.empty()) return "is empty";
  if (name == kWallName) return "is the wall's";
  return taken.insert(name).second ? "" : "is another port's";
}

}  // namespace

std::vector<std::string> patchNamesOf(const std::vector<Port>& ports) {
  std::vector<std::string> names{kWallName};
  for (const Port& port : ports) names.push_back(port.name);
  return names;
}

void writePorts(const std::vector<Port>& ports, const fs::path& path) {
  Json list = Json::array();
  std::set<std::string> names;
  for (const Port& port : ports) {
    if (const std::string fault = nameFault(port.name, names); !fault.empty())
      throw InputError("the name of port " + std::to_string(list.size() + 1) + " " + fault,
                       path.string(), "give each port a name of its own");
    if (!port.centreLps.allFinite() || !port.normalLps.allFinite() || !std::isfinite(port.areaMm2))
      throw InputError("the port '" + port.name + "' has a measure that is no number",
                       path.string(), "cut the surface again");
    list.push_back(portJson<Json>(port));
  }
  const Json json = {{"schema", kSchema}, {"frame", "LPS"}, {"unit", "mm"}, {"ports", list}};
  writeText(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::vector<Port> readPorts(const fs::path& path) {
  const Json json = parseJson<Json>(readText(path, kMostJsonBytes));
  if (json.is_discarded()) throw IoError("the file is no JSON", path.string(), kCopyAgain);
  if (!json.is_object() || !json.contains("schema") || !json.contains("ports"))
    throw InputError("not a file of ports", path.string(), "give a ports.json");
  const JsonPlace root(path.string());
  checkSchema(json.at("schema"), kSchema, "the ports were", path.string());
  const std::vector<Json> values = valuesOf(json, {"schema", "frame", "unit", "ports"}, root);
  expect(values[1], "LPS", root.in("frame"));
  expect(values[2], "mm", root.in("unit"));
  const JsonPlace place = root.in("ports");
  if (!values[3].is_array()) place.refuse("is no list");
  std::vector<Port> ports;
  std::set<std::string> names;
  for (std::size_t n = 0; n < values[3].size(); ++n) {
    ports.push_back(portIn(values[3][n], place.at(n)));
    if (const std::string fault = nameFault(ports.back().name, names); !fault.empty())
      place.at(n).in("name").refuse(fault);
  }
  return ports;
}

}  // namespace angiomesh

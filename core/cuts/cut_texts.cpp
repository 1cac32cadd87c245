// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/cuts.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/openings/port.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr const char* kForm = "write x,y,z,NAME or x,y,z,nx,ny,nz,NAME, in mm LPS";
constexpr const char* kNameForm = "write border_1=NAME, or x,y,z=NAME with a place in mm LPS";
constexpr const char* kNames = "ports.names";
constexpr const char* kCuts = "ports.cuts";

/// Whether a text has letters, digits, '_', '-' and '.' only, and one of them at least.
bool isWord(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return (c < 128 && std::isalnum(c) != 0) || c == '_' || c == '-' || c == '.';
  });
}

std::vector<std::string> piecesOf(const std::string& text) {
  std::vector<std::string> pieces;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    std::string piece = text.substr(start, end - start);
    const std::size_t first = piece.find_first_not_of(' ');
    pieces.push_back(first == std::string::npos
                         ? ""
                         : piece.substr(first, piece.find_last_not_of(' ') - first + 1));
    start = end + 1;
  }
  return pieces;
}

/// Three numbers from `first` on. @throws InputError that names `field` and says the form it has
Vector3d placeOf(const std::vector<std::string>& pieces, std::size_t first, const std::string& text,
                 const char* field, const char* form) {
  Vector3d place;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::string& piece = pieces[first + a];
    double& value = place[static_cast<Eigen::Index>(a)];
    const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), value);
    if (error != std::errc() || end != piece.data() + piece.size() || !std::isfinite(value))
      throw InputError("'" + piece + "' is no number in '" + text + "'", field, form);
  }
  return place;
}

std::string listText(const Vector3d& place) {
  return shortestText(place.x()) + "," + shortestText(place.y()) + "," + shortestText(place.z());
}

}  // namespace

void checkPortName(const std::string& name) {
  if (!isWord(name))
    throw InputError("'" + name + "' is no name for a port", kCuts,
                     "use letters, digits, '_', '-' and '.'");
  if (name == kWallName || name.starts_with(kBorderPrefix))
    throw InputError("'" + name + "' is a name that the program gives itself", kCuts,
                     "choose another name");
}

GivenCut parseCut(const std::string& text) {
  const std::vector<std::string> pieces = piecesOf(text);
  if (pieces.size() != 4 && pieces.size() != 7)
    throw InputError("'" + text + "' is no cut", kCuts, kForm);
  GivenCut cut;
  cut.pointLps = placeOf(pieces, 0, text, kCuts, kForm);
  if (pieces.size() == 7) {
    const Vector3d normal = placeOf(pieces, 3, text, kCuts, kForm);
    if (!(normal.norm() > 1e-9))
      throw InputError("the normal of the cut '" + text + "' has no length", kCuts, kForm);
    if (!std::isfinite(normal.norm()))
      throw InputError("the normal of the cut '" + text + "' is too long", kCuts, kForm);
    cut.normalLps = normal;
  }
  cut.name = pieces.back();
  checkPortName(cut.name);
  return cut;
}

std::string cutText(const GivenCut& cut) {
  std::string text = listText(cut.pointLps) + ",";
  if (cut.normalLps) text += listText(*cut.normalLps) + ",";
  return text + cut.name;
}

std::set<std::string> cutNames(const std::vector<std::string>& cuts) {
  std::set<std::string> names;
  for (const std::string& text : cuts) names.insert(parseCut(text).name);
  return names;
}

void checkPorts(const PortParams& params) {
  std::set<std::string> names;
  for (const std::string& text : params.cuts) {
    const GivenCut cut = parseCut(text);
    if (!names.insert(cut.name).second)
      throw InputError("two cuts are called '" + cut.name + "'", kCuts,
                       "give each a name of its own");
  }
  std::set<std::string> ports;
  for (const std::string& text : params.names) {
    const PortNaming naming = parsePortNaming(text);
    if (!ports.insert(naming.port).second)
      throw InputError("the port '" + naming.port + "' gets two names", kNames,
                       "give it one of them");
    if (!names.insert(naming.name).second)
      throw InputError("two ports are called '" + naming.name + "'", kNames,
                       "give each a name of its own");
  }
}

PortNaming parsePortNaming(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError("'" + text + "' names no port", kNames, kNameForm);
  PortNaming naming;
  naming.name = text.substr(equals + 1);
  checkPortName(naming.name);
  naming.port = text.substr(0, equals);
  if (isWord(naming.port)) return naming;
  const std::vector<std::string> pieces = piecesOf(naming.port);
  if (pieces.size() != 3)
    throw InputError("'" + naming.port + "' is neither a port's name nor a place", kNames,
                     kNameForm);
  naming.placeLps = placeOf(pieces, 0, text, kNames, kNameForm);
  return naming;
}

std::string portNamingText(const PortNaming& naming) {
  return (naming.placeLps ? listText(*naming.placeLps) : naming.port) + "=" + naming.name;
}

void addPorts(const std::vector<Port>& ports, PortParams& params) {
  for (const Port& port : ports) {
    if (!port.atBorder)
      params.cuts.push_back(cutText({port.centreLps, port.normalLps, port.name}));
    else if (!port.name.starts_with(kBorderPrefix))
      params.names.push_back(portNamingText({"", port.centreLps, port.name}));
  }
}

}  // namespace angiomesh

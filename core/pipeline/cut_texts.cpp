// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/cuts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/surface/port.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr const char* kForm = "write x,y,z,NAME or x,y,z,nx,ny,nz,NAME, in mm LPS";
constexpr const char* kBorderPrefix = "border_";

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

double numberOf(const std::string& piece, const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), value);
  if (error != std::errc() || end != piece.data() + piece.size() || !std::isfinite(value))
    throw InputError("'" + piece + "' is no number in the cut '" + text + "'", "ports.cuts", kForm);
  return value;
}

std::string shortest(double value) {
  std::array<char, 40> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace

void checkPortName(const std::string& name) {
  const bool word = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c < 128 && std::isalnum(c) != 0) || c == '_' || c == '-' || c == '.';
  });
  if (!word)
    throw InputError("'" + name + "' is no name for a port", "ports.cuts",
                     "use letters, digits, '_', '-' and '.'");
  if (name == kWallName || name.starts_with(kBorderPrefix))
    throw InputError("'" + name + "' is a name that the program gives itself", "ports.cuts",
                     "choose another name");
}

GivenCut parseCut(const std::string& text) {
  const std::vector<std::string> pieces = piecesOf(text);
  if (pieces.size() != 4 && pieces.size() != 7)
    throw InputError("'" + text + "' is no cut", "ports.cuts", kForm);
  GivenCut cut;
  for (int a = 0; a < 3; ++a) cut.pointLps[a] = numberOf(pieces[static_cast<std::size_t>(a)], text);
  if (pieces.size() == 7) {
    Vector3d normal;
    for (int a = 0; a < 3; ++a) normal[a] = numberOf(pieces[static_cast<std::size_t>(a) + 3], text);
    if (!(normal.norm() > 1e-9))
      throw InputError("the normal of the cut '" + text + "' has no length", "ports.cuts", kForm);
    cut.normalLps = normal;
  }
  cut.name = pieces.back();
  checkPortName(cut.name);
  return cut;
}

std::string cutText(const GivenCut& cut) {
  std::string text;
  for (int a = 0; a < 3; ++a) text += shortest(cut.pointLps[a]) + ",";
  if (cut.normalLps)
    for (int a = 0; a < 3; ++a) text += shortest((*cut.normalLps)[a]) + ",";
  return text + cut.name;
}

void checkPorts(const PortParams& params) {
  std::set<std::string> names;
  for (const std::string& text : params.cuts) {
    const GivenCut cut = parseCut(text);
    if (!names.insert(cut.name).second)
      throw InputError("two cuts are called '" + cut.name + "'", "ports.cuts",
                       "give each a name of its own");
  }
  std::set<std::string> ports;
  for (const std::string& text : params.names) {
    const auto [port, name] = parsePortName(text);
    if (!ports.insert(port).second)
      throw InputError("the port '" + port + "' gets two names", "ports.names",
                       "give it one of them");
    if (!names.insert(name).second)
      throw InputError("two ports are called '" + name + "'", "ports.names",
                       "give each a name of its own");
  }
}

std::array<std::string, 2> parsePortName(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    throw InputError("'" + text + "' names no port", "ports.names", "write border_1=NAME");
  const std::string name = text.substr(equals + 1);
  checkPortName(name);
  return {text.substr(0, equals), name};
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/nrrd_geometry.h"

#include <Eigen/Dense>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "io/file/length_unit.h"
#include "io/file/text_scanner.h"
#include "io/volume/header_text.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kDirections = "space directions";

/// A number, NaN and infinity included. @throws InputError
double numberOf(std::string word, const std::string& field, const fs::path& path) {
  if (word.starts_with('+')) word.erase(0, 1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throwBadHeader(path, field + " holds '" + word + "'");
  return value;
}

std::string fieldOf(const NrrdFields& fields, const char* name, const char* other = "") {
  auto found = fields.find(name);
  if (found == fields.end()) found = fields.find(other);
  return found == fields.end() ? std::string() : found->second;
}

/// The numbers of a field for the wanted axes; unknown ones where there is no such field.
Eigen::Vector3d perAxis(const NrrdFields& fields, const char* name, const char* other,
                        const std::vector<std::size_t>& axes, const fs::path& path) {
  Eigen::Vector3d values = Eigen::Vector3d::Constant(kUnknown);
  const std::vector<std::string> words = nrrdWords(fieldOf(fields, name, other));
  if (words.empty()) return values;
  for (std::size_t a = 0; a < 3; ++a) {
    if (axes[a] >= words.size()) throwBadHeader(path, std::string(name) + " is too short");
    values[static_cast<Eigen::Index>(a)] = numberOf(words[axes[a]], name, path);
  }
  if (values.array().isInf().any()) throwBadHeader(path, std::string(name) + " is infinite");
  return values;
}

/// The signs that turn the axes of the file's space to left, back and head.
Eigen::Vector3d signsOfSpace(const NrrdFields& fields, const fs::path& path,
                             std::vector<std::string>& warnings) {
  const std::string space = fieldOf(fields, "space");
  std::string name = inSmall(space);
  std::erase_if(name, [](char c) { return c == '-' || c == ' ' || c == '_'; });
  if (name.ends_with("time")) name.resize(name.size() - 4);
  const auto is = [&](const char* whole, const char* letters) {
    return name == whole || name == letters || name == std::string(letters) + "t";
  };
  if (is("leftposteriorsuperior", "lps")) return {1, 1, 1};
  if (is("rightanteriorsuperior", "ras")) return {-1, -1, 1};
  if (is("leftanteriorsuperior", "las")) return {1, -1, 1};
  if (name == "scannerxyz" || name == "3drighthanded" || name == "3dlefthanded") {
    warnings.push_back("the space of the file is '" + space +
                       "', which does not say how the patient lies: its axes are taken for left, "
                       "back and head" +
                       (name == "3dlefthanded" ? ", and all may be mirrored" : ""));
    return {1, 1, 1};
  }
  if (!name.empty()) throwBadHeader(path, "space is '" + space + "'");
  if (fields.count("space dimension") != 0 || fields.count(kDirections) != 0)
    warnings.emplace_back(
        "the file states its axes in a space without a name: they are taken for left, back and "
        "head");
  return {1, 1, 1};
}

/// mm for each unit of the three axes of space or of the grid.
Eigen::Vector3d unitsOf(const std::string& text, const std::vector<std::size_t>& axes,
                        std::vector<std::string>& warnings) {
  Eigen::Vector3d mm = Eigen::Vector3d::Ones();
  const std::vector<std::string> words = nrrdWords(text);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::string unit = axes[a] < words.size() ? words[axes[a]] : std::string();
    if (unit.empty()) continue;
    if (const auto known = millimetresOf(unit)) {
      mm[static_cast<Eigen::Index>(a)] = *known;
      continue;
    }
    const std::string warning = unknownUnit(unit);
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(warning);
  }
  return mm;
}

/// Spacings that are not known become 1 mm, and a warning.
void assumeSpacing(Eigen::Vector3d& spacing, std::vector<std::string>& warnings) {
  if (spacing.array().isNaN().all()) {
    warnings.emplace_back(kNoSpacing);
    spacing.setOnes();
  }
  for (Eigen::Index a = 0; a < 3; ++a)
    if (std::isnan(spacing[a])) {
      warnings.push_back("the file does not state the voxel spacing along axis " +
                         std::to_string(a + 1) + ": 1 mm is assumed");
      spacing[a] = 1.0;
    }
}

/// Says that a field has other spacings than the one that is taken; NaN: none.
void sayOther(const Eigen::Vector3d& taken, const std::string& field, const Eigen::Vector3d& others,
              const std::string& otherField, std::vector<std::string>& warnings) {
  constexpr double seen = 0.01;
  for (Eigen::Index a = 0; a < 3; ++a) {
    const double one = std::fabs(taken[a]), other = std::fabs(others[a]);
    if (!(std::fabs(other - one) > seen * one)) continue;
    std::ostringstream text;
    text.precision(4);
    text << "the voxels of the file are " << one << " mm long along axis " << a + 1 << " by its "
         << field << " and " << other << " mm by its " << otherField << ": the " << field
         << " are taken";
    warnings.push_back(text.str());
    return;
  }
}

/// Of a file without directions: spacings, or what follows from the places of its ends, which also
/// say where the first voxel is. In the middle of its cell, unless the file says "node".
Geometry alongAxes(const NrrdFields& fields, const std::vector<std::size_t>& axes,
                   const std::vector<std::uintmax_t>& sizes, const fs::path& path,
                   std::vector<std::string>& warnings) {
  Geometry g;
  g.spacing = perAxis(fields, "spacings", "", axes, path);
  const Eigen::Vector3d least = perAxis(fields, "axis mins", "axismins", axes, path);
  const Eigen::Vector3d most = perAxis(fields, "axis maxs", "axismaxs", axes, path);
  const std::vector<std::string> centres = nrrdWords(fieldOf(fields, "centers", "centerings"));
  const Eigen::Vector3d mm = unitsOf(fieldOf(fields, "units"), axes, warnings);
  Eigen::Vector3d ends;
  std::array<bool, 3> node{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    node[a] = axes[a] < centres.size() && centres[axes[a]] == "node";
    const auto steps = static_cast<double>(node[a] ? sizes[a] - 1 : sizes[a]);
    ends[i] = steps > 0.0 ? (most[i] - least[i]) / steps : kUnknown;
    ends[i] *= mm[i];
    g.spacing[i] = std::isnan(g.spacing[i]) ? ends[i] : g.spacing[i] * mm[i];
  }
  sayOther(g.spacing, "spacings", ends, "axis mins and maxs", warnings);
  assumeSpacing(g.spacing, warnings);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    if (g.spacing[i] == 0.0) throwBadHeader(path, "a voxel spacing is 0");
    if (!std::isnan(least[i]))
      g.origin[i] = least[i] * mm[i] + (node[a] ? 0.0 : 0.5 * g.spacing[i]);
    // A negative spacing is the same grid with this axis turned round.
    if (g.spacing[i] < 0.0) g.direction.col(i) *= -1.0;
    g.spacing[i] = std::fabs(g.spacing[i]);
  }
  return g;
}

/// The part of a vector in space: its first three numbers, of four where the last is time.
Eigen::Vector3d inSpace(const std::vector<double>& vector, const char* field,
                        const fs::path& path) {
  if (vector.size() < 3 || vector.size() > 4)
    throwBadHeader(path, std::string(field) + " are not those of 3D space");
  return {vector[0], vector[1], vector[2]};
}

}  // namespace

std::vector<std::string> nrrdWords(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r", at)) != std::string::npos;) {
    const bool quoted = text[at] == '"';
    if (quoted) ++at;
    std::size_t end = text.find_first_of(quoted ? "\"" : " \t\r", at);
    if (end == std::string::npos) end = text.size();
    words.push_back(text.substr(at, end - at));
    at = std::min(end + 1, text.size());
  }
  return words;
}

std::vector<std::optional<std::vector<double>>> nrrdVectors(const std::string& text,
                                                            const std::string& field,
                                                            const fs::path& path) {
  std::vector<std::optional<std::vector<double>>> vectors;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r", at)) != std::string::npos;) {
    if (text.compare(at, 4, "none") == 0) {
      vectors.emplace_back();
      at += 4;
      continue;
    }
    const std::size_t end = text.find(')', at);
    if (text[at] != '(' || end == std::string::npos || vectors.size() > 16)
      throwBadHeader(path, field + " is '" + text + "'");
    std::string inner = text.substr(at + 1, end - at - 1);
    std::replace(inner.begin(), inner.end(), ',', ' ');
    std::vector<double> vector;
    for (const std::string& word : nrrdWords(inner)) vector.push_back(numberOf(word, field, path));
    // pynrrd writes a vector of NaN where there is none.
    const bool none = std::all_of(vector.begin(), vector.end(), [](double v) { return v != v; });
    vectors.push_back(none ? std::nullopt : std::optional(vector));
    at = end + 1;
  }
  return vectors;
}

Geometry nrrdGeometry(const NrrdFields& fields, const std::vector<std::size_t>& axes,
                      const std::vector<std::uintmax_t>& sizes, const fs::path& path,
                      std::vector<std::string>& warnings) {
  const auto vectors = nrrdVectors(fieldOf(fields, kDirections), kDirections, path);
  const Eigen::Vector3d signs = signsOfSpace(fields, path, warnings);
  const Eigen::Vector3d mm = unitsOf(fieldOf(fields, "space units"), {0, 1, 2}, warnings);
  const auto toLps = (signs.array() * mm.array()).matrix().asDiagonal();
  Geometry g;
  int directions = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (axes[a] >= vectors.size() || !vectors[axes[a]]) continue;
    const auto i = static_cast<Eigen::Index>(a);
    const Eigen::Vector3d step = toLps * inSpace(*vectors[axes[a]], kDirections, path);
    g.spacing[i] = step.norm();
    if (!(g.spacing[i] > 0.0) || !step.allFinite())
      throwBadHeader(path, std::string(kDirections) + " is '" + fields.at(kDirections) + "'");
    g.direction.col(i) = step / g.spacing[i];
    ++directions;
  }
  if (directions == 0) {
    g = alongAxes(fields, axes, sizes, path, warnings);
    g.direction = signs.asDiagonal() * g.direction;
    g.origin = signs.asDiagonal() * g.origin;
  } else if (directions < 3) {
    throwBadHeader(path, std::string(kDirections) + " is '" + fields.at(kDirections) + "'");
  } else {
    const std::string units = fieldOf(fields, "units");
    const Eigen::Vector3d spacings = perAxis(fields, "spacings", "", axes, path);
    sayOther(g.spacing, kDirections,
             spacings.cwiseProduct(units.empty() ? mm : unitsOf(units, axes, warnings)), "spacings",
             warnings);
  }
  const auto origin = nrrdVectors(fieldOf(fields, "space origin"), "space origin", path);
  if (origin.size() == 1 && origin.front())
    g.origin = toLps * inSpace(*origin.front(), "space origin", path);
  for (std::size_t a = 0; a < 3; ++a) g.size[a] = static_cast<int>(sizes[a]);
  g.direction.array() += 0.0;  // -0 becomes 0
  g.origin.array() += 0.0;
  return g;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <limits>
#include <set>

#include "core/openings/port.h"
#include "io/file/text_scanner.h"

namespace angiomesh {
namespace {

constexpr std::size_t kMostPatches = std::size_t{1} << 16U;

/// One word, and no statement of a frame or unit.
std::string cleanName(const std::string& name) {
  std::string clean;
  for (const char c : name) clean += c > ' ' && c < 127 && c != '=' ? c : '_';
  return clean;
}

std::string nameOfNumber(std::size_t patch) {
  return patch == 0 ? kWallName : "patch_" + std::to_string(patch);
}

/// Cleaned, all there and all different. Returns how many have a number for the sake of that.
std::size_t makeUsable(std::vector<std::string>& names) {
  std::size_t renamed = 0;
  std::set<std::string> taken;
  std::map<std::string, int> last;
  for (std::size_t patch = 0; patch < names.size(); ++patch) {
    const std::string name = names[patch].empty() ? nameOfNumber(patch) : cleanName(names[patch]);
    names[patch] = name;
    // Counting on from the last number: many equal names take no time that grows with their square.
    for (int& number = last.try_emplace(name, 1).first->second; !taken.insert(names[patch]).second;)
      names[patch] = name + "-" + std::to_string(++number);
    if (names[patch] != name) ++renamed;
  }
  return renamed;
}

double areaOf(const PolygonMesh& mesh, const std::vector<std::uint32_t>& polygon) {
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  const std::size_t count = mesh.points.size();
  for (std::size_t c = 1; c + 1 < polygon.size(); ++c) {
    if (polygon[0] >= count || polygon[c] >= count || polygon[c + 1] >= count) return 0.0;
    const Eigen::Vector3d& first = mesh.points[polygon[0]];
    twice += (mesh.points[polygon[c]] - first).cross(mesh.points[polygon[c + 1]] - first);
  }
  return 0.5 * twice.norm();
}

bool isWall(const std::string& name) {
  const std::string wall = kWallName;
  return std::equal(name.begin(), name.end(), wall.begin(), wall.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

}  // namespace

std::vector<std::string> patchNamesFor(const TriMesh& mesh, const std::vector<std::string>& names) {
  std::vector<std::string> usable = names;
  if (mesh.patch.empty()) {
    usable.resize(1);
    if (usable[0].empty()) usable[0] = "surface";
  } else {
    const std::size_t last = *std::max_element(mesh.patch.begin(), mesh.patch.end());
    usable.resize(std::max(usable.size(), last + 1));
    if (std::find(mesh.patch.begin(), mesh.patch.end(), 0) == mesh.patch.end())
      usable[0] = kWallName;
  }
  makeUsable(usable);
  return usable;
}

std::vector<std::vector<std::uint32_t>> trianglesByPatch(const TriMesh& mesh, std::size_t count) {
  std::vector<std::vector<std::uint32_t>> triangles(count);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    triangles[mesh.patch.empty() ? 0 : mesh.patch[t]].push_back(t);
  return triangles;
}

std::string wholeName(std::string_view line) {
  TextScanner scan(line);
  std::string name;
  for (std::string_view word = scan.word(); !word.empty(); word = scan.word()) {
    if (word.find('=') != std::string_view::npos) break;
    name += (name.empty() ? "" : " ") + std::string(word);
  }
  return name;
}

std::uint32_t GroupsByName::number(std::string_view name) {
  const auto next = static_cast<std::uint32_t>(mesh_.groupNames.size());
  if (!name.empty()) {
    const auto [entry, isNew] = numbers_.emplace(name, next);
    if (!isNew) {
      ++again_;
      return entry->second;
    }
  }
  mesh_.groupNames.emplace_back(name);
  return next;
}

void groupByNumber(PolygonMesh& mesh, const std::vector<double>& numbers,
                   std::map<std::uint32_t, std::string> names, const std::string& prefix) {
  const auto isNumber = [](double value) {
    return value >= 0.0 && value <= std::numeric_limits<std::int32_t>::max() &&
           value == static_cast<double>(static_cast<std::uint32_t>(value));
  };
  mesh.oddGroups = numbers.size() != mesh.polygons.size() ||
                   !std::all_of(numbers.begin(), numbers.end(), isNumber);
  if (mesh.oddGroups) return;
  for (const double value : numbers) {
    const auto number = static_cast<std::uint32_t>(value);
    names.try_emplace(number, prefix + std::to_string(number));
  }
  std::unordered_map<std::uint32_t, std::uint32_t> groups;
  for (const auto& [number, name] : names) {
    groups[number] = static_cast<std::uint32_t>(mesh.groupNames.size());
    mesh.groupNames.push_back(name);
  }
  for (const double value : numbers)
    mesh.groups.push_back(groups[static_cast<std::uint32_t>(value)]);
}

void groupByEntity(PolygonMesh& mesh, const std::vector<double>& numbers) {
  std::map<double, double> areas;
  if (numbers.size() == mesh.polygons.size())
    for (std::size_t p = 0; p < numbers.size(); ++p)
      areas[numbers[p]] += areaOf(mesh, mesh.polygons[p]);
  std::map<std::uint32_t, std::string> names;
  if (areas.size() > 1 && (areas.begin()->first == 0.0 || areas.begin()->first == 1.0)) {
    const auto largest =
        std::max_element(areas.begin(), areas.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (largest == areas.begin()) {
      names[static_cast<std::uint32_t>(largest->first)] = kWallName;
      mesh.remarks.push_back("of VMTK's CellEntityIds, the patches, " +
                             std::to_string(static_cast<int>(largest->first)) +
                             " is taken for the wall");
    }
  }
  groupByNumber(mesh, numbers, std::move(names), "face_");
}

PatchSet patchesOfGroups(const std::vector<std::uint32_t>& groups,
                         const std::vector<std::string>& names) {
  PatchSet set;
  const std::size_t count = names.size();
  std::size_t wall = std::find(names.begin(), names.end(), kWallName) - names.begin();
  if (wall == count) wall = std::find_if(names.begin(), names.end(), isWall) - names.begin();
  // A wall without triangles is there in any mesh.
  const bool bare = wall < count && std::find(groups.begin(), groups.end(), wall) == groups.end();
  const std::size_t stated = count - (bare ? 1 : 0);
  if (stated == 0) return set;
  if (stated == 1) {
    set.names.push_back(cleanName(bare && wall == 0 ? names.back() : names.front()));
    if (set.names[0].empty()) set.names.clear();
    return set;
  }
  set.tooMany = stated + 1 > kMostPatches;
  if (set.tooMany) return set;
  set.names.emplace_back(wall < count ? names[wall] : kWallName);
  std::vector<std::uint16_t> patchOf(count, 0);
  for (std::size_t group = 0; group < count; ++group) {
    if (group == wall) continue;
    patchOf[group] = static_cast<std::uint16_t>(set.names.size());
    set.names.push_back(names[group]);
  }
  set.renamed = makeUsable(set.names);
  for (const std::uint32_t group : groups) set.patch.push_back(patchOf[group]);
  return set;
}

}  // namespace angiomesh

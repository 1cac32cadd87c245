// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/mesh_files.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "app/session/session.h"

namespace angiomesh::cli {
namespace {

/// Whether a name holds nothing but words that models for flow solvers use, and numbers.
bool isPlainName(const std::string& name) {
  static const std::set<std::string> words{
      "aneurysm", "aorta",  "artery", "boundary", "branch", "cap",   "default", "end",
      "face",     "in",     "inflow", "inlet",    "left",   "lumen", "mesh",    "out",
      "outflow",  "outlet", "part",   "patch",    "port",   "right", "solid",   "stl",
      "surface",  "vein",   "vessel", "vessels",  "wall",   "walls"};
  std::string word;
  for (const char c : name + ' ') {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (!word.empty() && words.count(word) == 0) return false;
    word.clear();
  }
  // A long number may be a patient's.
  return std::count_if(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; }) <= 3;
}

}  // namespace

Frame frameFromOption(const std::string& word) { return word == "ras" ? Frame::Ras : Frame::Lps; }

LengthUnit unitFromOption(const std::string& word) {
  return word == "m" ? LengthUnit::Metre : LengthUnit::Millimetre;
}

MeshReadOptions meshReadOptions(const std::string& frame, const std::string& unit) {
  MeshReadOptions options;
  if (!frame.empty()) options.frame = frameFromOption(frame);
  if (!unit.empty()) options.unit = unitFromOption(unit);
  return options;
}

MeshReadOptions MeshReading::options(const std::string& frame, const std::string& unit) const {
  MeshReadOptions options = meshReadOptions(frame, unit);
  options.keepPoints = keepPoints;
  options.mergeDistanceMm = mergeDistanceMm;
  return options;
}

std::vector<CLI::Option*> addMeshReading(CLI::App& command, MeshReading& reading) {
  constexpr double kLeastMm = 1e-9, kMostMm = 10.0;
  return {command.add_flag("--keep-points", reading.keepPoints,
                           "Leave points of the mesh apart that lie at one place (of STL, they are "
                           "always one)"),
          command
              .add_option("--merge-distance", reading.mergeDistanceMm,
                          "Close cracks: make one of points at open edges of the mesh that lie "
                          "within so many mm of each other")
              ->check(CLI::Range(kLeastMm, kMostMm))};
}

std::vector<std::string> plainPatchNames(const LoadedMesh& loaded, bool& any) {
  std::vector<std::string> names = loaded.patchNames;
  if (!loaded.key.empty()) return names;
  for (std::size_t patch = 0; patch < names.size(); ++patch) {
    if (isPlainName(names[patch])) continue;
    any = true;
    names[patch] = names.size() == 1 ? "surface" : "part-" + std::to_string(patch);
  }
  return names;
}

bool Soundness::mayWrite() const {
  if (fault.empty()) return true;
  if (allowed) printWarning(fault + ": a flow solver will refuse it");
  return allowed;
}

int Soundness::refuse(const std::string& left, const std::string& advice) const {
  printError(fault + ": " + left + "; " + advice +
             ", or write it all the same with --allow-unsound");
  return GateFailed;
}

void addSoundness(CLI::App& command, Soundness& soundness) {
  command.add_flag("--allow-unsound", soundness.allowed,
                   "Write the surface even if it cuts itself or is no manifold");
}

void writeChecked(const TriMesh& mesh, const std::filesystem::path& place, const std::string& name,
                  const MeshWriteOptions& options) {
  for (const std::string& warning : writeMesh(mesh, place, options))
    printWarning(warning + ", " + name);
  checkMeshFile(mesh, place, options);
}

}  // namespace angiomesh::cli

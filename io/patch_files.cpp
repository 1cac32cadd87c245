// SPDX-License-Identifier: BSD-3-Clause
#include "io/patch_files.h"

#include <cctype>
#include <limits>
#include <set>

#include "core/surface/outward.h"
#include "io/mesh_patch.h"

namespace angiomesh {
namespace {

std::string inSmallLetters(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

}  // namespace

TriMesh patchSurface(const TriMesh& mesh, std::size_t patch) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  TriMesh part;
  for (std::size_t t = 0; t < mesh.patch.size(); ++t) {
    if (mesh.patch[t] != patch) continue;
    std::array<std::uint32_t, 3> triangle = mesh.triangles[t];
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& mine = number[corner];
      if (mine == kNone) {
        mine = static_cast<std::uint32_t>(part.points.size());
        part.points.push_back(mesh.points[corner]);
      }
      corner = mine;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

std::vector<std::string> fileWords(const std::vector<std::string>& names) {
  std::vector<std::string> words;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string word;
    for (const char c : name) {
      const bool fits = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.';
      word += fits && !(c == '.' && word.empty()) ? c : '_';
    }
    const std::string first = word;
    for (int number = 2; !taken.insert(inSmallLetters(word)).second; ++number)
      word = first + "-" + std::to_string(number);
    words.push_back(word);
  }
  return words;
}

std::vector<std::filesystem::path> writePatchFiles(const TriMesh& mesh,
                                                   const std::filesystem::path& path,
                                                   const MeshWriteOptions& options) {
  checkMesh(mesh);
  TriMesh outward = mesh;
  turnOutward(outward);
  const std::vector<std::string> names = patchNamesFor(mesh, options.patchNames);
  const std::vector<std::string> words = fileWords(names);
  std::vector<std::filesystem::path> files;
  for (std::size_t patch = 0; patch < names.size(); ++patch) {
    const TriMesh part = patchSurface(outward, patch);
    if (part.triangles.empty()) continue;
    MeshWriteOptions write = options;
    write.patchNames = {names[patch]};
    std::filesystem::path file = path;
    file.replace_filename(path.stem().string() + "_" + words[patch] + path.extension().string());
    writeMesh(part, file, write);
    checkMeshFile(part, file, write);
    files.push_back(file);
  }
  return files;
}

}  // namespace angiomesh

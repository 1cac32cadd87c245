// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/patch_files.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/outward.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/file/text_scanner.h"
#include "io/mesh/mesh_patch.h"

namespace angiomesh {
namespace {}  // namespace

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
    for (int number = 2; !taken.insert(inSmall(word)).second; ++number)
      word = first + "-" + std::to_string(number);
    words.push_back(word);
  }
  return words;
}

std::vector<std::string> renamedWords(const std::vector<std::string>& names,
                                      const std::vector<std::string>& words,
                                      const std::string& where) {
  std::vector<std::string> sentences;
  for (std::size_t n = 0; n < names.size(); ++n)
    if (words[n].size() > names[n].size())
      sentences.push_back("the patch '" + names[n] + "' is called " + words[n] + " " + where +
                          ", where another one has its name");
  return sentences;
}

std::vector<std::filesystem::path> writePatchFiles(const TriMesh& mesh,
                                                   const std::filesystem::path& path,
                                                   const MeshWriteOptions& options,
                                                   std::vector<std::string>* warnings) {
  checkMesh(mesh);
  TriMesh outward = mesh;
  turnOutward(outward);
  const std::vector<std::string> patches = patchNamesFor(mesh, options.patchNames);
  const std::vector<std::string> words = fileWords(patches);
  std::vector<std::pair<std::size_t, std::string>> files;  // patch, name
  std::vector<std::string> names;
  for (std::size_t patch = 0; patch < patches.size(); ++patch) {
    if (std::find(mesh.patch.begin(), mesh.patch.end(), patch) == mesh.patch.end()) continue;
    files.emplace_back(patch,
                       path.stem().string() + "_" + words[patch] + path.extension().string());
    names.push_back(files.back().second);
  }
  if (warnings != nullptr) names.push_back(path.filename().string());
  const std::filesystem::path folder = folderOf(path);
  if (std::error_code error; !std::filesystem::is_directory(folder, error))
    throw IoError("cannot write the file, there is no such folder", path.string(),
                  "make the folder first or choose another place");
  StagedFolder staged(folder, names, true, StagedFolder::Writers::Many);
  std::vector<std::filesystem::path> written;
  for (const auto& [patch, name] : files) {
    const TriMesh part = patchSurface(outward, patch);
    MeshWriteOptions write = options;
    write.patchNames = {patches[patch]};
    staged.add(name, [&](const std::filesystem::path& place) {
      writeMesh(part, place, write);
      checkMeshFile(part, place, write);
    });
    written.push_back(path.parent_path() / name);
  }
  if (warnings != nullptr)
    staged.add(path.filename().string(), [&](const std::filesystem::path& place) {
      *warnings = writeMesh(mesh, place, options);
      checkMeshFile(mesh, place, options);
    });
  staged.commit();
  return written;
}

}  // namespace angiomesh

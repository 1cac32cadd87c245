// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/openfoam_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <system_error>

#include "core/base/error.h"
#include "core/mesh/inside_point.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/outward.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"
#include "io/mesh/mesh_io.h"
#include "io/vessel/openfoam_text.h"
#include "io/vessel/patch_files.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

const char* const kSurface = "constant/triSurface/vessel.stl";

constexpr double kCellsAcross = 11.0;
/// Enough for long vessels, and a second's work for blockMesh.
constexpr double kMostBackgroundCells = 2e5;
constexpr int kMostLevels = 12;
/// Of the background mesh beyond the surface on each side, in cells; no round number, so that flat
/// caps do not lie in the faces of cells.
constexpr double kMargin = 1.37;

/// Words that OpenFOAM's dictionaries take for a name: no number is one.
std::vector<std::string> patchWords(const std::vector<Port>& ports,
                                    std::vector<std::string>& warnings) {
  std::vector<std::string> names{kWallName};
  for (const Port& port : ports) {
    const bool letter =
        !port.name.empty() && (std::isalpha(static_cast<unsigned char>(port.name[0])) != 0);
    names.push_back(letter ? port.name : "port_" + port.name);
  }
  std::vector<std::string> words = fileWords(names);
  for (std::string& word : words) std::replace(word.begin(), word.end(), '.', '_');
  words = fileWords(words);
  warnings = renamedWords(names, words, "in the case");
  return words;
}

struct RimEdges {
  std::size_t open = 0, crowded = 0;
};

RimEdges countRimEdges(const TriMesh& mesh) {
  RimEdges count;
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edgeRunEnd(sides, i);
    if (end == i + 1) ++count.open;
    if (end > i + 2) ++count.crowded;
  }
  return count;
}

void checkUsable(const TriMesh& mesh, const std::vector<Port>& ports, const fs::path& folder) {
  const auto refuse = [&](const std::string& what, const std::string& advice) {
    throw InputError(what, folder.string(), advice);
  };
  checkMesh(mesh);
  if (!isClosed(mesh)) {
    const RimEdges rim = countRimEdges(mesh);
    refuse("the surface is not closed (" + std::to_string(rim.open) + " open edges, " +
               std::to_string(rim.crowded) +
               " of more than two triangles), so that it has no inside to be filled",
           "cap its openings as patches of their own, join its cracks with --merge-distance, or "
           "make a closed surface with 'mesh --cut'");
  }
  if (ports.empty() || mesh.patch.empty())
    refuse("the mesh has no ports, so that nothing could flow through it",
           "cut the vessels, or give a mesh with the patches 'wall', inlets and outlets");
  std::vector<std::size_t> counts(ports.size() + 1, 0);
  for (const std::uint16_t patch : mesh.patch) {
    if (patch >= counts.size())
      refuse("a triangle is in patch " + std::to_string(patch) + ", and there are " +
                 std::to_string(ports.size()) + " ports",
             "give a port for each patch");
    ++counts[patch];
  }
  const auto empty = std::find(counts.begin(), counts.end(), std::size_t{0});
  if (empty == counts.end()) return;
  const auto patch = static_cast<std::size_t>(empty - counts.begin());
  refuse("the patch '" + (patch == 0 ? std::string(kWallName) : ports[patch - 1].name) +
             "' has no triangles",
         patch == 0 ? "call the wall's solid, group or face 'wall'" : "cut the surface again");
}

std::array<int, 3> cellsOf(const Eigen::Vector3d& size, double cell) {
  std::array<int, 3> cells{};
  for (int a = 0; a < 3; ++a)
    cells[static_cast<std::size_t>(a)] =
        static_cast<int>(std::ceil(size[a] / cell + 2.0 * kMargin));
  return cells;
}

/// The background mesh gives the widest port its cells, unless that were too many; halves of them
/// give the narrowest its own.
void layOutCells(const TriMesh& mesh, OpenFoamMesh& plan) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(1e-3 * p);
  const auto [least, most] = std::minmax_element(plan.diameters.begin(), plan.diameters.end());
  plan.finest = std::min(kMostLevels, static_cast<int>(std::log2(*most / *least) + 1e-6));
  plan.cell = std::ldexp(*least / kCellsAcross, plan.finest);
  for (; plan.finest < kMostLevels; ++plan.finest) {
    const Eigen::Vector3d cells = (box.sizes() / plan.cell).array() + 2.0 * kMargin;
    if (cells.prod() <= kMostBackgroundCells) break;
    plan.cell *= 2.0;
  }
  plan.cells = cellsOf(box.sizes(), plan.cell);
  plan.low = box.min().array() - kMargin * plan.cell;
  for (int a = 0; a < 3; ++a)
    plan.high[a] = plan.low[a] + plan.cell * plan.cells[static_cast<std::size_t>(a)];
  const auto levelFor = [&](double diameter) {
    const double halvings = std::log2(kCellsAcross * plan.cell / diameter);
    return std::clamp(static_cast<int>(std::ceil(halvings - 1e-6)), 0, plan.finest);
  };
  plan.levels.push_back(levelFor(*most));
  for (const double diameter : plan.diameters) plan.levels.push_back(levelFor(diameter));
}

/// In the middle of a finest cell: a point in the face of cells belongs to none.
Eigen::Vector3d insideACell(const TriMesh& mesh, const OpenFoamMesh& plan) {
  const InsidePoint inside = pointInside(mesh);
  const Eigen::Vector3d point = 1e-3 * inside.pointLps;
  const double cell = std::ldexp(plan.cell, -plan.finest);
  const Eigen::Vector3d middle =
      plan.low + cell * (((point - plan.low) / cell).array().floor() + 0.5).matrix();
  return 1e-3 * inside.depthMm > cell ? middle : point;
}

void checkFolder(const fs::path& folder, bool replace) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  const fs::path parent = (whole.has_filename() ? whole : whole.parent_path()).parent_path();
  if (!fs::is_directory(parent, error))
    throw IoError("there is no such folder", parent.string(), "make it first");
  if (!replace && fs::is_directory(folder, error) && !fs::is_empty(folder, error))
    throw InputError("the folder is not empty", folder.string(),
                     "choose another folder, or replace the case in it with --force");
}

}  // namespace

OpenFoamCase writeOpenFoamCase(const TriMesh& mesh, const std::vector<Port>& ports,
                               const fs::path& folder, bool replace) {
  checkUsable(mesh, ports, folder);
  TriMesh outward = mesh;
  turnOutward(outward);
  OpenFoamCase result;
  OpenFoamMesh& plan = result.mesh;
  plan.patches = patchWords(ports, result.warnings);
  for (const Port& port : measurePatches(outward, ports.size()))
    plan.diameters.push_back(1e-3 * port.equivalentDiameterMm());
  if (!(*std::min_element(plan.diameters.begin(), plan.diameters.end()) > 0.0))
    throw InputError("a port has no area", folder.string(), "cut the surface again");
  layOutCells(outward, plan);
  plan.inside = insideACell(outward, plan);
  if (const std::size_t count = meshComponents(outward).count; count > 1)
    result.warnings.push_back("the surface has " + std::to_string(count) +
                              " components: snappyHexMesh fills only the largest");

  const std::map<std::string, std::string> texts = openFoamTexts(plan);
  std::vector<std::string> names{kSurface};
  for (const auto& [name, text] : texts) names.push_back(name);
  checkFolder(folder, replace);
  StagedFolder staged(folder, names, replace);
  staged.add(kSurface, [&](const fs::path& place) {
    MeshWriteOptions write;
    write.unit = LengthUnit::Metre;
    write.encoding = MeshEncoding::Ascii;
    write.patchNames = plan.patches;
    writeMesh(outward, place, write);
    checkMeshFile(outward, place, write);
  });
  for (const auto& entry : texts)
    staged.add(entry.first, [&](const fs::path& place) {
      writeText(place, entry.second);
      if (entry.first == "Allrun")
        fs::permissions(place, fs::perms::owner_exec | fs::perms::group_exec,
                        fs::perm_options::add);
    });
  staged.commit();
  return result;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "io/mesh/polygon_mesh.h"

namespace angiomesh {

/// Names of the patches 0 to the last that has a triangle or a name, as files hold them: one word
/// of printable ASCII without '=' each, all different. See MeshWriteOptions::patchNames. A patch 0
/// without triangles is called "wall". Of a mesh without patches: the name of its solid.
std::vector<std::string> patchNamesFor(const TriMesh& mesh, const std::vector<std::string>& names);

/// The triangles of each of `count` patches, in their order.
std::vector<std::vector<std::uint32_t>> trianglesByPatch(const TriMesh& mesh, std::size_t count);

/// The name that a line states: all its words, up to a statement such as SPACE=LPS, without the
/// blanks around it.
std::string wholeName(std::string_view line);

/// Numbers for the groups of a mesh by their names. Groups without a name stay apart.
class GroupsByName {
 public:
  explicit GroupsByName(PolygonMesh& mesh) : mesh_(mesh) {}
  std::uint32_t number(std::string_view name);
  /// How often number() was asked for a name that it had met before.
  [[nodiscard]] std::size_t again() const { return again_; }

 private:
  PolygonMesh& mesh_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::size_t again_ = 0;
};

/// Groups out of the number of each polygon, in the order of the numbers; one that `names` does not
/// name is called `prefix` and its number. What is no whole number, or not one for each polygon,
/// leaves the mesh without groups and says so.
void groupByNumber(PolygonMesh& mesh, const std::vector<double>& numbers,
                   std::map<std::uint32_t, std::string> names, const std::string& prefix);

/// As groupByNumber(), of VMTK's `CellEntityIds`: 1, or 0, is the wall where that is the lowest
/// number and has the most area; said in a remark.
void groupByEntity(PolygonMesh& mesh, const std::vector<double>& numbers);

struct PatchSet {
  std::vector<std::uint16_t> patch;
  std::vector<std::string> names;
  std::size_t renamed = 0;  ///< groups whose cleaned name another one has; a number is behind it
  bool tooMany = false;     ///< for numbers of 16 bits: there are none
};

/// Patches out of the groups of triangles, see loadMesh().
PatchSet patchesOfGroups(const std::vector<std::uint32_t>& groups,
                         const std::vector<std::string>& names);

}  // namespace angiomesh

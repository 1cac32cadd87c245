// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/surface/tri_mesh.h"
#include "io/polygon_mesh.h"

namespace angiomesh {

/// Names of the patches 0 to the last that has a triangle or a name, as files hold them: one word
/// of printable ASCII without '=' each, all different. See MeshWriteOptions::patchNames. A patch 0
/// without triangles is called "wall". Of a mesh without patches: the name of its solid.
std::vector<std::string> patchNamesFor(const TriMesh& mesh, const std::vector<std::string>& names);

/// The triangles of each of `count` patches, in their order.
std::vector<std::vector<std::uint32_t>> trianglesByPatch(const TriMesh& mesh, std::size_t count);

/// Numbers for the groups of a mesh by their names. Groups without a name stay apart.
class GroupsByName {
 public:
  explicit GroupsByName(PolygonMesh& mesh) : mesh_(mesh) {}
  std::uint32_t number(std::string_view name);

 private:
  PolygonMesh& mesh_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

/// Groups out of the number of each polygon, in the order of the numbers; one that `names` does not
/// name is called `prefix` and its number. What is no whole number, or not one for each polygon,
/// leaves the mesh without groups and says so.
void groupByNumber(PolygonMesh& mesh, const std::vector<double>& numbers,
                   std::map<std::uint32_t, std::string> names, const std::string& prefix);

struct PatchSet {
  std::vector<std::uint16_t> patch;
  std::vector<std::string> names;
  bool tooMany = false;  ///< for numbers of 16 bits: there are none
};

/// Patches out of the groups of triangles, see loadMesh().
PatchSet patchesOfGroups(const std::vector<std::uint32_t>& groups,
                         const std::vector<std::string>& names);

}  // namespace angiomesh

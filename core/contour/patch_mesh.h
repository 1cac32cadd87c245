// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "core/openings/end_planes.h"

namespace angiomesh {

/// Where a triangle of the surface came from.
enum class FaceOrigin : std::uint8_t {
  Front,    ///< a free or connection triangle of the advancing front
  Closing,  ///< put in to close what the front left open
  Remesh,   ///< of the remesher
  Contour   ///< of marching cubes
};

/// The surface between phi = 0 and the planes that it ends in while it is being made: the wall, and
/// flat caps. mesh.patch stays empty.
struct PatchMesh {
  TriMesh mesh;
  std::vector<Place> place;          ///< per vertex
  std::vector<std::uint16_t> patch;  ///< per triangle: 0 wall, 1 + a the cap in plane a (EndPlanes)
  std::vector<FaceOrigin> origin;    ///< per triangle
  std::vector<std::uint32_t> group;  ///< per triangle, a number that edits keep; may be empty
};

/// The triangles that `keep(number)` names, in their order, with the points they use.
template <class Keep>
PatchMesh selectTriangles(const PatchMesh& from, Keep keep) {
  constexpr std::uint32_t none = 0xffffffffU;
  PatchMesh out;
  std::vector<std::uint32_t> number(from.mesh.points.size(), none);
  for (std::uint32_t t = 0; t < from.mesh.triangles.size(); ++t) {
    if (!keep(t)) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = from.mesh.triangles[t][k];
      if (number[v] == none) {
        number[v] = static_cast<std::uint32_t>(out.mesh.points.size());
        out.mesh.points.push_back(from.mesh.points[v]);
        out.place.push_back(from.place[v]);
      }
      corners[k] = number[v];
    }
    out.mesh.triangles.push_back(corners);
    out.patch.push_back(from.patch[t]);
    out.origin.push_back(from.origin[t]);
    if (!from.group.empty()) out.group.push_back(from.group[t]);
  }
  return out;
}

}  // namespace angiomesh

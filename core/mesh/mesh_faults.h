// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {

/// Where a mesh is no surface that a solver could take: triangles that meet outside what they
/// share, edges of more than two triangles or of two that disagree in orientation, vertices of more
/// than one fan. Rims are a fault only of what is to be closed.
struct MeshFaults {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting;  ///< see selfIntersections()
  std::vector<std::uint32_t> broken;  ///< triangles at such edges and vertices, sorted
  std::size_t places = 0;             ///< patches of such triangles that have no corner in common
  Eigen::Vector3d placeLps{0.0, 0.0, 0.0};  ///< the middle of the largest of these, mm

  [[nodiscard]] bool none() const { return meeting.empty() && broken.empty(); }
  /// "cuts itself in 12 places, such as near L 1.0 P 2.0 S 3.0 mm"
  [[nodiscard]] std::string text() const;
};

/// The triangles at edges of more than two triangles or of two that disagree in orientation, at
/// rims that may not end the surface, and at vertices of more than one fan; sorted.
std::vector<std::uint32_t> brokenTriangles(const TriMesh& mesh,
                                           const std::function<bool(const EdgeSide&)>& mayEnd);

/// Counts the places of the triangles that are listed.
void locateFaults(const TriMesh& mesh, MeshFaults& faults);

/// @throws Cancelled
MeshFaults findFaults(const TriMesh& mesh, bool closed, const Progress& progress = {});

}  // namespace angiomesh

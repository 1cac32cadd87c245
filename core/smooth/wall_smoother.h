// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/smooth/wall_vertices.h"

namespace angiomesh {

/// One run of keepWallSmooth(): vertices slide along the wall, edges are flipped, the worst
/// triangles are worked on one by one, and the volume between mesh and wall is given back.
class WallSmoother : public WallVertices {
 public:
  using WallVertices::WallVertices;

  TriMesh run(const Progress& progress);

 private:
  [[nodiscard]] int excess(std::uint32_t v, int change) const;
  [[nodiscard]] bool worthFlipping(std::uint32_t h, bool byValence) const;
  void flipEdges(bool byValence, const Progress& progress);
  [[nodiscard]] Fitness around(std::uint32_t v, const Ring& ring, std::size_t n,
                               const Vector3d& place, const Vector3d& normal) const;
  bool improve(std::uint32_t v);
  std::size_t improveWorst(const Progress& progress);
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/remesh/remesh_vertices.h"

namespace angiomesh {

/// Flips, splits and collapses of a mesh's edges.
class RemeshEdges : public RemeshVertices {
 public:
  using RemeshVertices::RemeshVertices;

  /// Brings the density of the mesh to the wanted edge lengths.
  void resize();
  /// Flips and relaxation of a mesh of the right density.
  void even();

 protected:
  enum class FlipBy { Valence, Shape };

  [[nodiscard]] double stretch(std::uint32_t h) const;
  [[nodiscard]] bool flipAgrees(std::uint32_t h) const;
  [[nodiscard]] bool flipKeepsWall(std::uint32_t h) const;
  [[nodiscard]] bool worthFlipping(std::uint32_t h, FlipBy by) const;
  std::size_t flipEdges(FlipBy by, bool all);
  void activate(std::uint32_t v);
  [[nodiscard]] Place splitPlace(std::uint32_t h) const;
  std::uint32_t splitEdge(std::uint32_t h);
  [[nodiscard]] bool collapseFits(std::uint32_t h, double longest, Vector3d& point) const;
  bool collapseEdge(std::uint32_t h, double longest);
  std::size_t splitLong();
  std::size_t collapseShort();
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/mesh/tri_mesh.h"

class vtkActor;
class vtkLookupTable;

namespace angiomesh {

/// A mesh as it is drawn. Making it takes a while, and any thread may.
struct DrawnMesh;
/// @param mesh may be null   @param coarseTriangles more than these are drawn by some as many while
/// the actor is coarse; 0: never   @param hidden one triangle each of the connected parts that are
/// not drawn
std::shared_ptr<const DrawnMesh> drawnMesh(std::shared_ptr<const TriMesh> mesh,
                                           std::size_t coarseTriangles = 0,
                                           const std::vector<std::size_t>& hidden = {});
/// What it was made of. May be null.
const std::shared_ptr<const TriMesh>& meshOf(const DrawnMesh& drawn);
/// What is drawn: the mesh without the hidden parts. May be null.
const std::shared_ptr<const TriMesh>& visibleMesh(const DrawnMesh& drawn);
/// The triangle of the whole mesh that one of visibleMesh() is.
std::size_t originalTriangle(const DrawnMesh& drawn, std::size_t visible);

/// A triangle mesh as a lit actor, in one colour or coloured per triangle.
class SurfaceActor {
 public:
  /// @param colour RGB, 0..1, of the outside
  explicit SurfaceActor(const std::array<double, 3>& colour);
  ~SurfaceActor();
  SurfaceActor(const SurfaceActor&) = delete;
  SurfaceActor& operator=(const SurfaceActor&) = delete;

  [[nodiscard]] vtkActor* actor() const;
  /// Null or an empty mesh shows nothing. Colours of another number of triangles are dropped.
  void setMesh(std::shared_ptr<const DrawnMesh> mesh);
  /// Fewer triangles, without their edges, in place of many.
  void setCoarse(bool coarse);
  [[nodiscard]] bool empty() const;
  void setVisible(bool visible);
  void setEdgesVisible(bool visible);
  /// Hardly lit, as what is out of date.
  void setDimmed(bool dimmed);
  /// Of the patches 1.. of the mesh, RGB, 0..1; the rest, and all patches beyond the last, keep the
  /// actor's colour. Values of triangles hide them.
  void setPatchColours(std::vector<std::array<double, 3>> colours);
  /// Empty: without values again.
  void setTriangleValues(std::vector<float> values, vtkLookupTable* table);
  [[nodiscard]] bool coloured() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace angiomesh

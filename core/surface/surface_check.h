// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/front/grow_front.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/zero_set_mesh.h"

namespace angiomesh {

/// What is known of a surface, component by component.
struct SurfaceCheck {
  MeshComponents parts;
  std::vector<SurfaceComponent> components;  ///< per label of `parts`
  /// Per component of the landmarks that has one: the label of the part that reaches most of its
  /// landmarks (`none` when no part reaches half of them), and how many none reaches.
  struct Reached {
    std::uint32_t component = 0;  ///< its smallest landmark
    std::uint32_t part = 0;
    std::size_t landmarks = 0, missed = 0;
    std::vector<std::uint32_t> parts;  ///< all that reach a twentieth of its landmarks
  };
  static constexpr std::uint32_t none = 0xffffffffU;
  std::vector<Reached> reached;
};

/// The first of the checks below: manifold, oriented, closed but for rims.
SurfaceCheck checkManifold(const PatchMesh& mesh, SurfaceBorder border);

/// Takes out the components that checkManifold() doubts: improving their triangles makes no sense.
void dropBroken(PatchMesh& mesh, SurfaceBorder border);

/// The same, and which part reaches which component of the landmarks; what is missed is no doubt
/// yet.
SurfaceCheck checkReach(const PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                        const Landmarks& landmarks, SurfaceBorder border);

/// Goes on with what checkReach() found of the same mesh of phi = 0, so that each component is
/// verified, or doubted with a reason, to be
/// - an oriented manifold whose rims lie in the planes that it ends in (no rims with `Cap`),
/// - nowhere turned away from the field: on each wall triangle and around it, as far as its feet on
///   the zero set, the gradient has a positive part along the triangle's normal (see
///   turnedFaces()); the zero set has no critical point there, and the mesh maps to it one to one
///   along the gradient;
/// - within reach of every landmark of the zero set (most of them decide which component a
///   landmark's belongs to).
void finishCheck(SurfaceCheck& check, const PatchMesh& mesh, const SplineField& field,
                 const Progress& progress);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"
#include "core/openings/end_planes.h"
#include "core/sizing/guidance_field.h"

namespace angiomesh {

/// The wanted length of edges near the surface, mm.
class EdgeSize {
 public:
  virtual ~EdgeSize() = default;
  [[nodiscard]] virtual double at(const Eigen::Vector3d& pointLps) const = 0;

 protected:
  EdgeSize() = default;
  EdgeSize(const EdgeSize&) = default;
  EdgeSize& operator=(const EdgeSize&) = default;
};

/// Adaptive isotropic remeshing (Botsch and Kobbelt 2004) on the zero set of `field`: edges longer
/// than 4/3 of the wanted length are split and those shorter than 4/5 collapsed, edges flipped
/// towards even valences and vertices relaxed along the surface, then as improveTriangles().
/// `start` is a manifold near the zero set, such as marching cubes; its topology, planes and
/// patches stay (vertices that are not part of a manifold stay in place, and those with `held` set,
/// which may be empty). Every triangle's origin becomes Remesh; groups stay. The same for any
/// number of threads.
/// @throws InputError when the arrays of `start` do not fit together, Cancelled
PatchMesh remesh(const PatchMesh& start, const SplineField& field, const EdgeSize& size,
                 const EndPlanes& ends, const Progress& progress = {},
                 const std::vector<char>& held = {});
PatchMesh remesh(const PatchMesh& start, const SplineField& field, const GuidanceField& size,
                 const EndPlanes& ends, const Progress& progress = {},
                 const std::vector<char>& held = {});

/// Makes good triangles of a mesh that has the wanted density already: edges are flipped and
/// vertices relaxed along the surface, then the worst triangles are worked on one by one (flips,
/// relocation, collapses, splits) until every angle is at least 33 and at most 105 degrees or no
/// change helps. The vertices end on phi = 0 (to 1e-6 voxel), in their planes or corners; topology
/// and patches stay. The same for any number of threads.
/// @throws InputError when the arrays of `mesh` do not fit together, Cancelled
void improveTriangles(PatchMesh& mesh, const SplineField& field, const EdgeSize& size,
                      const EndPlanes& ends, const Progress& progress = {});
void improveTriangles(PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                      const EndPlanes& ends, const Progress& progress = {});

}  // namespace angiomesh

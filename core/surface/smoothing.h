// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/progress.h"
#include "core/surface/spline_field.h"
#include "core/surface/tri_mesh.h"

namespace angiomesh {

enum class SmoothMethod { KeepWall, Taubin, None };

struct SmoothParams {
  SmoothMethod method = SmoothMethod::KeepWall;
  int iterations = 50;   ///< pairs of a lambda and a mu step
  double lambda = 0.50;  ///< thesis 4.3, eq. 4.6
  double mu = -0.54;     ///< thesis 4.3, eq. 4.7
  double wallBoundVoxels =
      0.05;  ///< KeepWall: largest distance of a vertex from phi = 0, working voxels
};

/// Taubin's lambda-mu filter (Taubin 1995; thesis eq. 4.5-4.7) with uniform weights 1/valence: each
/// iteration is one step with lambda, then one with mu. Vertices of an open rim average along the
/// rim only.
TriMesh taubinSmooth(const TriMesh& mesh, const SmoothParams& params,
                     const Progress& progress = {});

/// Smooths the triangulation, not the vessel: vertices move as by taubinSmooth() but within the
/// wall. With `phi`, each vertex is brought back to within wallBoundVoxels of phi = 0; without it,
/// to the same distance from the input surface. Topology and number of vertices stay.
TriMesh keepWallSmooth(const TriMesh& mesh, const SmoothParams& params,
                       const SplineField* phi = nullptr, const Progress& progress = {});

/// By params.method; `None` returns the mesh as it is.
TriMesh smoothSurface(const TriMesh& mesh, const SmoothParams& params,
                      const SplineField* phi = nullptr, const Progress& progress = {});

}  // namespace angiomesh

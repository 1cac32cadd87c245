// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/pipeline/parameters.h"

namespace angiomesh {

/// What is known of how a surface came to be. Marching cubes leaves all but the method empty: it
/// checks nothing and follows no size.
struct SurfaceOrigin {
  SurfaceMethod method = SurfaceMethod::MarchingCubes;
  std::vector<SurfaceComponent> components;  ///< largest first
  std::optional<double> fromFrontPercent;    ///< of the triangles, for AdvancingFront
  std::optional<double> estimatedTriangles;  ///< before meshing
  std::vector<std::string> dropped;          ///< what was left out, in words

  [[nodiscard]] std::size_t unverified() const;
  /// A sentence for each component that was not verified and for each piece that was left out.
  [[nodiscard]] std::vector<std::string> warnings() const;
};

struct MadeSurface {
  TriMesh mesh;
  SurfaceOrigin origin;
};

/// The surface of phi = 0 before smoothing; `field` interpolates `phi`. Components that enclose
/// less than minComponentMm3 are left out; the mesh may be empty.
/// @throws Cancelled
MadeSurface makeSurface(const Volume<float>& phi, const SplineField& field,
                        const SurfaceParams& params, const Progress& progress = {});

/// The number of triangles that the size field asks for, before meshing.
/// @throws Cancelled
double estimateTriangles(const SplineField& field, const SurfaceParams& params,
                         const Progress& progress = {});

}  // namespace angiomesh

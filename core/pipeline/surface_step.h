// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/pipeline/parameters.h"
#include "core/surface/cut_away.h"
#include "core/surface/port.h"

namespace angiomesh {

/// What is known of how a surface came to be. Marching cubes leaves all but the method empty: it
/// checks nothing and follows no size.
struct SurfaceOrigin {
  SurfaceMethod method = SurfaceMethod::MarchingCubes;
  std::vector<SurfaceComponent> components;  ///< largest area first
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
  /// As ZeroSetMesh::ports; of marching cubes without cuts none, and the mesh has no patches.
  std::vector<Port> ports;
  std::vector<std::size_t> lostCuts;  ///< by number: the part that they end was left out
};

/// The surface of phi = 0 before smoothing, without what `away` takes; `field` interpolates `phi`.
/// Components that enclose less than minComponentMm3 are left out, with `largestAlone` all but the
/// one of most area; cuts that end what is left out are no ports. The mesh may be empty. With
/// cuts marching cubes has its caps at the volume's border in the outermost planes of voxel
/// centres.
/// @throws InputError, as clipReference(); Cancelled
MadeSurface makeSurface(const Volume<float>& phi, const SplineField& field,
                        const SurfaceParams& params, const Progress& progress = {},
                        const CutAway& away = {}, bool largestAlone = false);

/// The number of triangles that the size field asks for, before meshing.
/// @throws Cancelled
double estimateTriangles(const SplineField& field, const SurfaceParams& params,
                         const Progress& progress = {}, const CutAway& away = {});

}  // namespace angiomesh

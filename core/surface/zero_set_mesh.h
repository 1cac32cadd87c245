// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/contour/marching_cubes.h"
#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"
#include "core/openings/cut_away.h"
#include "core/openings/port.h"
#include "core/sizing/guidance_field.h"
#include "core/sizing/sizing.h"

namespace angiomesh {

enum class SurfaceMethod { AdvancingFront, MarchingCubes, Remesh };

/// One edge-connected part of a surface.
struct SurfaceComponent {
  std::size_t triangles = 0;
  double areaMm2 = 0.0;
  int euler = 0;
  int boundaryLoops = 0;
  bool verified = false;   ///< the checks of meshZeroSet() hold for it
  std::string why;         ///< else: which one does not
  double volumeMm3 = 0.0;  ///< meaningful when closed
  double fromFrontPercent = 0.0;
  SurfaceMethod method = SurfaceMethod::AdvancingFront;  ///< what made it in the end
  std::string instead;  ///< why not the method that was asked for, in words
  std::string faults;   ///< where it cuts itself, or another, or is no manifold, in words

  /// As if the rims were closed.
  [[nodiscard]] int genus() const { return (2 - boundaryLoops - euler) / 2; }
};

struct ZeroSetMesh {
  TriMesh mesh;
  std::vector<FaceOrigin> origin;            ///< per triangle
  std::vector<SurfaceComponent> components;  ///< largest area first
  double fromFrontPercent = 0.0;
  double estimatedTriangles = 0.0;  ///< before meshing
  /// The openings, port n patch 1 + n of the mesh: the cuts in their order, then border_1, ... ,
  /// the caps at the volume's border (with `Open`: the rims), the largest first. As the mesh has
  /// them; of a cut whose component was dropped the area is 0.
  std::vector<Port> ports;
  std::vector<std::string> dropped;  ///< what was too small to be meshed, in words
};

/// The zero set of the field as triangles of the wanted size with well-shaped corners, faces
/// counter-clockwise from outside, vertices on the zero set; by the advancing front or, for
/// `Remesh`, by remeshing marching cubes; without what `away` takes. `Cap` closes it by flat caps
/// in the outermost planes of voxel centres and in the sections of `away`, `Open` leaves planar
/// rims there. Each triangle has its patch. The same for any number of threads.
///
/// Each component is checked: it is an oriented manifold, closed but for rims; it turns nowhere
/// away from the field's gradient by 90 degrees or more, bounded from the spline's second
/// derivatives around each triangle; it covers the crossings of the zero set with the edges of the
/// grid. Where fronts leave no manifold, or triangles of a component that did not pass the checks
/// intersect, the place is taken out and filled anew. Where no part of the front's mesh reaches a
/// component of marching cubes, that is remeshed instead.
/// @throws InputError for `MarchingCubes`, and as clipReference(); Cancelled
ZeroSetMesh meshZeroSet(const SplineField& field, const SizingParams& sizing, SurfaceMethod method,
                        SurfaceBorder border, const Progress& progress = {},
                        const CutAway& away = {});

/// The same with the sizes at hand: those of the field without what `away` takes.
ZeroSetMesh meshZeroSet(const SplineField& field, const GuidanceField& size, SurfaceMethod method,
                        SurfaceBorder border, const Progress& progress = {},
                        const CutAway& away = {});

}  // namespace angiomesh

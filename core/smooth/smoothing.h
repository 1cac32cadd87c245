// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/mesh/tri_mesh.h"
#include "core/openings/port.h"

namespace angiomesh {

enum class SmoothMethod { KeepWall, Taubin, None };

struct SmoothParams {
  SmoothMethod method = SmoothMethod::KeepWall;
  int iterations = 50;   ///< pairs of a lambda and a mu step
  double lambda = 0.50;  ///< Taubin: thesis 4.3, eq. 4.6
  double mu = -0.54;     ///< Taubin: thesis 4.3, eq. 4.7
  double wallBoundVoxels =
      0.05;  ///< KeepWall: largest distance of a vertex from phi = 0, working voxels

  bool operator==(const SmoothParams&) const = default;
};

/// Taubin's lambda-mu filter (Taubin 1995; thesis eq. 4.5-4.7) with uniform weights 1/valence: each
/// iteration is one step with lambda, then one with mu. Vertices of rims, open ones and those
/// between patches, average along the rim only; those of patches, and of open rims at `ports`, stay
/// in their planes.
/// @throws InputError (see checkMesh), Cancelled
TriMesh taubinSmooth(const TriMesh& mesh, const SmoothParams& params, const Progress& progress = {},
                     const std::vector<Port>& ports = {});

/// Smooths the triangulation, not the vessel; 0 iterations change nothing.
/// Good triangles inscribed in phi = 0 (of the advancing front and the remesher; see
/// inscribedInZeroSet()) need no smoothing, but enclose less than a convex wall: their vertices
/// move along the wall's normal by the mean height of the wall over the triangles around them, so
/// that each component encloses the zero set's volume; lambda and wallBoundVoxels play no part, and
/// surroundings of triangles that would come to meet stay as they were. Rims and caps, of patches
/// and in the outermost planes of voxel centres of phi, stay in their planes, and rims come to
/// enclose the area of phi < 0 there (see offsetBySagitta()). On other meshes, such as marching
/// cubes: in each of `iterations` sweeps, or until nothing moves, the vertices slide along the wall
/// to where the triangles around them are best, and edges are flipped (as by remesh(); lambda and
/// mu are Taubin's); then the worst triangles are worked on one by one, and the volume that the
/// input enclosed is given back place by place. The wall is phi = 0: vertices end within
/// wallBoundVoxels of it, except where a triangle would fold over. Without `phi` it is the input
/// surface, and the mean edge length counts as a voxel. Vertices of caps (patches, or outside the
/// outermost voxel centres of phi) and of open rims (there, and at `ports`) stay in their planes.
/// Topology and numbers of vertices and triangles stay, irregular vertices stay in place, and
/// surroundings of triangles that would come to meet are left as they were (see smoothSoundly();
/// the number of components left alone is added to `left`, which may be null). Of a mesh of which
/// some components alone are inscribed each is smoothed in its own way.
/// @throws InputError (see checkMesh), Cancelled
TriMesh keepWallSmooth(const TriMesh& mesh, const SmoothParams& params,
                       const SplineField* phi = nullptr, const Progress& progress = {},
                       const std::vector<Port>& ports = {}, std::size_t* left = nullptr);

/// By params.method; `None` returns the mesh as it is. No triangles come to meet that did not
/// before: with Taubin's filter too the surroundings of those that would stay in place.
TriMesh smoothSurface(const TriMesh& mesh, const SmoothParams& params,
                      const SplineField* phi = nullptr, const Progress& progress = {},
                      const std::vector<Port>& ports = {}, std::size_t* left = nullptr);

/// A sentence on components that smoothSurface() left alone.
std::string leftUnsmoothed(std::size_t count);

}  // namespace angiomesh

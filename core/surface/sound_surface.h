// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/contour/patch_mesh.h"
#include "core/field/spline_field.h"
#include "core/front/grow_front.h"
#include "core/openings/end_planes.h"
#include "core/sizing/guidance_field.h"
#include "core/surface/surface_check.h"
#include "core/surface/zero_set_mesh.h"

namespace angiomesh {

/// What a surface is made on; all must outlive the object.
struct SurfaceGround {
  const PatchMesh& reference;  ///< marching cubes, see referenceSurface()
  const Landmarks& landmarks;  ///< of its wall
  const SplineField& field;
  const GuidanceField& size;
  const EndPlanes& ends;
  SurfaceBorder border;
};

/// Parts of a surface that are made, and replaced, as a whole.
struct SurfaceGroup {
  SurfaceMethod method = SurfaceMethod::AdvancingFront;
  std::string instead;  ///< why not by the method before, in words; empty for the first
  std::string faults;   ///< those that are left, in words
};

struct SoundSurface {
  PatchMesh mesh;                    ///< with groups
  bool changed = false;              ///< other triangles than in the mesh that was given
  std::vector<SurfaceGroup> groups;  ///< by number
  std::vector<std::string> dropped;  ///< what had to be left out, in words
};

/// Replaces what of a mesh of phi = 0 is no oriented manifold, closed but for rims, or meets itself
/// or other parts, by the soundest that can be made of it. A group is what is replaced at once:
/// components of the reference, and the parts of the mesh that `check` says reach them. In turn a
/// group is
/// - of the front: filled anew where it meets itself;
/// - remeshed from the reference, with shorter edges where those wanted are longer than the part is
///   thick; where that meets anything still the reference's triangles stay, in
///   surroundings that grow with each of some attempts;
/// - the reference itself, which meets nothing as each triangle lies in a cell of its own, its
///   vertices kept away from the corners of the grid.
/// `method` made the mesh: by the front, or by remeshing (its groups are then the reference's
/// components, by label). Groups that no front has reached are remeshed.
/// @throws Cancelled
SoundSurface makeSound(PatchMesh mesh, SurfaceMethod method, const SurfaceCheck& check,
                       const SurfaceGround& ground, const Progress& progress);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/openings/cut_away.h"
#include "core/openings/port.h"
#include "core/parameters/parameters.h"
#include "core/sizing/guidance_field.h"
#include "core/topology/handles.h"

namespace angiomesh {

/// What is known of how a surface came to be. Marching cubes leaves all but the method empty: it
/// checks nothing and follows no size.
struct SurfaceOrigin {
  SurfaceMethod method = SurfaceMethod::MarchingCubes;
  std::vector<SurfaceComponent> components;  ///< largest area first
  std::optional<double> fromFrontPercent;    ///< of the triangles, for AdvancingFront
  std::optional<double> estimatedTriangles;  ///< before meshing
  std::optional<double> smoothTriangles;     ///< see ExpectedSurface
  std::vector<std::string> dropped;          ///< what was left out, in words
  std::size_t lostCuts = 0;                  ///< that many of these, the first, are cuts
  /// Of the voxels of phi, where a component's genus is not 0. The interpolant may join or part
  /// voxels that touch at a corner otherwise.
  std::vector<Handle> handles;

  [[nodiscard]] std::size_t unverified() const;
  /// What is left wrong with the first component that no method could make soundly, in words.
  [[nodiscard]] std::string fault() const;
  /// Sentences on components that another method had to make or that were not verified, on pieces
  /// that were left out and on handles too small to be relied on; of each kind a few. Every lost
  /// cut is named.
  [[nodiscard]] std::vector<std::string> warnings() const;
};

/// What a surface will be, known before it is made.
struct ExpectedSurface {
  double triangles = 0.0;  ///< that the size field asks for, caps among them
  /// Of smooth round vessels as long and thick as these, with the same parameters.
  double smoothTriangles = 0.0;
  double smoothEdgeMm = 0.0;  ///< of these, where the vessels are thinnest, but for a tenth
  std::size_t parts = 0;      ///< of the segmentation
  /// Of these, those of less than a hundredth of the largest one's volume, and their share of
  /// smoothTriangles.
  std::size_t specks = 0;
  double speckTriangles = 0.0;

  [[nodiscard]] double bytes() const;    ///< of the whole program at its peak
  [[nodiscard]] double seconds() const;  ///< of processor time, rather too many
  /// triangles / smoothTriangles: about 1 to 2 where walls are smooth.
  [[nodiscard]] double roughness() const;
};

/// Asked before meshing begins, with the size field at hand; what it throws ends the step.
using Expectation = std::function<ExpectedSurface(const GuidanceField& size)>;

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
/// centres. Methods that follow the size field ask `expect`, if there is one.
/// @throws InputError, as clipReference() and `expect`; Cancelled
MadeSurface makeSurface(const Volume<float>& phi, const SplineField& field,
                        const SurfaceParams& params, const Progress& progress = {},
                        const CutAway& away = {}, bool largestAlone = false,
                        const Expectation& expect = {});

}  // namespace angiomesh

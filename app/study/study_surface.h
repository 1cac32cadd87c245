// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/parameters/parameters.h"
#include "core/phantom/phantom.h"
#include "core/quality/mesh_quality.h"
#include "core/quality/wall_accuracy.h"

namespace angiomesh::cli {

/// A shape that exported walls are measured on.
struct SurfaceShape {
  std::string name;
  PhantomParams phantom;
};

/// All shapes; `seed` draws the trees and moves and turns the others.
std::vector<SurfaceShape> surfaceShapes(std::uint64_t seed);

/// Those in `names` (with commas); all when empty. @throws InputError for a name of none
std::vector<SurfaceShape> chooseShapes(std::vector<SurfaceShape> shapes, const std::string& names);

/// A mesh against the true wall.
struct MeasuredMesh {
  MeshQuality quality;
  WallAccuracy wall;
};

/// A shape with one noise and point spread, through the whole pipeline.
struct SurfaceCase {
  SurfaceShape shape;
  MeasuredMesh exported, marchingCubes;
  double voxelMm = 1.0, seconds = 0.0;
  std::optional<double> trianglesAgainstNoNoise;
  std::string failure;  ///< of the pipeline; then nothing was measured
};

/// @throws Cancelled, InputError for a phantom that cannot be made
SurfaceCase runSurfaceCase(const SurfaceShape& shape, const Parameters& params,
                           const Progress& progress);

/// A condition on a case, and what was found.
struct SurfaceBar {
  std::string what;  ///< "spread <= 0.045"
  std::string name;  ///< "spread"
  bool reached = false;
};

/// The bars that hold for a case's noise; none for another noise than 0, 20 and 60.
std::vector<SurfaceBar> barsOf(const SurfaceCase& made);

}  // namespace angiomesh::cli

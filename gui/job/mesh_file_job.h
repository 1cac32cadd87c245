// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/step_results.h"

namespace angiomesh {

/// Reads a mesh and measures it against the wall that our meshes are measured against.
struct MeshFileJob {
  std::filesystem::path path;
  std::shared_ptr<const TriMesh> mesh;           ///< read before; null: to be read
  std::shared_ptr<const SurfaceResult> surface;  ///< null: there is no wall
  SplineKind spline = SplineKind::InterpolatingBspline;
  Progress progress;

  void execute() noexcept;

  // After execute(), beside the mesh:
  std::shared_ptr<const MeshQuality> quality;
  std::vector<std::string> warnings;  ///< of reading
  /// Where it is measured only in part, a sentence; else empty.
  std::string limits;
  std::string error;  ///< without the folder

 private:
  void measure();
};

}  // namespace angiomesh

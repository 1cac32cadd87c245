// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/quality/triangle_measures.h"
#include "gui/job/run_job.h"

namespace angiomesh {

/// A triangle with one of the worst values of its mesh.
struct WorstPlace {
  std::uint32_t triangle = 0;
  double value = 0.0;
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};
  Eigen::Vector3d normal{0.0, 0.0, 0.0};  ///< outwards; 0 where it has no area
  double edgeMm = 0.0;                    ///< mean
};

/// One measure on the meshes that are compared, and what is shown of it.
struct MeasuredMeshes {
  struct Of {
    std::shared_ptr<const TriMesh> mesh;  ///< null: there is none
    std::vector<float> values;
    std::vector<double> shares;  ///< of the bars, percent of the triangles that have a value
    std::vector<double> bands;   ///< percent, see bandShares()
    std::vector<WorstPlace> worst;
  };
  const TriangleMeasure* measure = nullptr;
  MeasureScale scale;
  double from = 0.0, to = 1.0;  ///< of the histogram, which all share
  int bars = 1;
  std::array<Of, kMeshKindCount> meshes;

  [[nodiscard]] const Of& of(MeshKind kind) const { return meshes[static_cast<std::size_t>(kind)]; }
  /// The bar that counts a value; the first and the last take what lies beyond. -1: not a number.
  [[nodiscard]] int barOf(float value) const;
};

/// Measures the meshes.
struct InspectJob {
  const TriangleMeasure* measure = nullptr;
  std::array<std::shared_ptr<const TriMesh>, kMeshKindCount> meshes;
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::shared_ptr<const MeasuredMeshes> measured;  ///< null: cancelled, or not enough memory
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "core/image/volume.h"

namespace angiomesh {

/// Which connected part of a segmentation a place on its surface belongs to.
struct PartJob {
  std::shared_ptr<const Volume<float>> phi;     ///< without cuts
  bool fullyConnected = true;                   ///< see connectedComponents()
  std::vector<Eigen::Vector3d> innerPointsLps;  ///< of the parts: centres of voxels
  Eigen::Vector3d placeLps{0.0, 0.0, 0.0};

  void execute() noexcept;

  // After execute():
  std::optional<std::size_t> part;  ///< nothing: no part has a voxel near the place
};

}  // namespace angiomesh

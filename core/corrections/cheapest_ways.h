// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// Cheapest ways over the 26 neighbours from one voxel to all others (Dijkstra): a step costs its
/// length in mm times the mean of both voxels' cost.
struct CheapestWays {
  static constexpr std::uint32_t none = 0xffffffffU;
  Volume<float> cost;               ///< of the way to each voxel; infinite where there is none
  std::vector<std::uint32_t> from;  ///< the voxel before on it; none at the start

  /// The voxels of the way to one, the start first.
  [[nodiscard]] std::vector<Index3> wayTo(const Index3& end) const;
};

/// @param costPerMm above 0; no way leads through infinite ones   @throws Cancelled
CheapestWays cheapestWays(const Volume<float>& costPerMm, const Index3& start,
                          const Progress& progress = {});

}  // namespace angiomesh

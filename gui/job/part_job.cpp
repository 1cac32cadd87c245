// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/part_job.h"

#include <cmath>
#include <exception>
#include <limits>

namespace angiomesh {

namespace {

constexpr int kReach = 3;  // voxels: smoothing moves a surface by less

std::int32_t labelAt(const Volume<std::int32_t>& labels, const Index3& v) {
  return labels.geometry.contains(v[0], v[1], v[2]) ? labels.at(v[0], v[1], v[2]) : 0;
}

Index3 voxelAt(const Geometry& g, const Eigen::Vector3d& lps) {
  const Eigen::Vector3d index = g.toIndex(lps);
  return {static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
          static_cast<int>(std::lround(index[2]))};
}

/// Of the labelled voxel whose centre is nearest; 0: none within reach.
std::int32_t nearestLabel(const Volume<std::int32_t>& labels, const Eigen::Vector3d& lps) {
  const Index3 middle = voxelAt(labels.geometry, lps);
  std::int32_t found = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = -kReach; k <= kReach; ++k)
    for (int j = -kReach; j <= kReach; ++j)
      for (int i = -kReach; i <= kReach; ++i) {
        const Index3 v{middle[0] + i, middle[1] + j, middle[2] + k};
        const std::int32_t label = labelAt(labels, v);
        if (label == 0) continue;
        const double distance =
            (labels.geometry.toPhysical(Eigen::Vector3d(v[0], v[1], v[2])) - lps).norm();
        if (distance < least) {
          least = distance;
          found = label;
        }
      }
  return found;
}

}  // namespace

void PartJob::execute() noexcept {
  try {
    const Volume<std::int32_t> labels =
        connectedComponents(insideMask(*phi), fullyConnected).labels;
    const std::int32_t label = nearestLabel(labels, placeLps);
    for (std::size_t i = 0; label != 0 && !part && i < innerPointsLps.size(); ++i)
      if (labelAt(labels, voxelAt(labels.geometry, innerPointsLps[i])) == label) part = i;
  } catch (const std::exception&) {
    part.reset();  // not enough memory
  }
}

}  // namespace angiomesh

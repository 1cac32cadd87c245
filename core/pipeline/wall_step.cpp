// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/wall_step.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/base/few_warnings.h"
#include "core/base/formatted.h"
#include "core/distance/redistance.h"
#include "core/field/wall_field.h"
#include "core/topology/close_handles.h"

namespace angiomesh {
namespace {

/// Standard deviations of the wall's place that a handle has to exceed to be believed.
constexpr double kSure = 3.0;
/// Working voxels: the least point spread of a scanner. That of voxels alone is 0.29.
constexpr double kScanner = 0.4;
/// Working voxels: a voxel's own doubt, and what no noise explains.
constexpr double kLeastDoubt = 0.15, kLargestDoubt = 0.5;

/// How far the wall may be wrong at each voxel, mm.
Volume<float> doubtOf(const Geometry& geometry, const WallEvidence& evidence) {
  const double voxel = geometry.voxelMm();
  Volume<float> doubt(geometry, static_cast<float>(kLargestDoubt * voxel));
  for (std::size_t e = 0; e < evidence.band.size(); ++e) {
    const auto contrast = static_cast<double>(evidence.lumen[e] - evidence.around[e]);
    if (!(contrast > 0.0)) continue;
    const double deviation = wallUncertainty(evidence.noise / contrast);
    doubt.voxels[evidence.band.voxel[e]] =
        static_cast<float>(std::clamp(kSure * deviation, kLeastDoubt, kLargestDoubt) * voxel);
  }
  return doubt;
}

void closeHandles(Volume<float>& phi, const WallEvidence& evidence, EvolveResult& result,
                  std::vector<std::string>& warnings, const Progress& progress) {
  HandleLimits limits;
  limits.depth = kLargestDoubt * phi.geometry.voxelMm();
  const Volume<float> doubt = doubtOf(phi.geometry, evidence);
  const std::vector<HandleChange> changes = closeSmallHandles(phi, limits, &doubt, progress);
  std::vector<std::string> closed;
  for (const HandleChange& change : changes) {
    ++(change.filled ? result.wall->filledHoles : result.wall->cutHandles);
    closed.push_back(formatted("%s near %s, which the noise explains, was %s (%zu voxels)",
                               change.filled ? "a hole through a vessel" : "a thin loop",
                               placeText(change.placeLps).c_str(), change.filled ? "filled" : "cut",
                               change.voxels));
  }
  addFew(warnings, closed, " more holes and loops that the noise explains were closed");
}

/// The smooth wall, its phi a distance again.
SmoothWall smoothWallDistance(Volume<float> phi, WallEvidence* evidence,
                              const SmoothWallParams& params, const Progress& progress) {
  SmoothWall wall = smoothWall(std::move(phi), evidence, params, progress.sub(0.0, 0.6));
  wall.phi = redistance(withRoundRidges(wall.phi), 5.0, progress.sub(0.6, 1.0));
  return wall;
}

}  // namespace

void placeWall(Volume<float> phi, WallEvidence* evidence, const SmoothWallParams& params,
               EvolveResult& result, std::vector<std::string>& warnings, const Progress& progress) {
  if (!params.enabled) {
    result.phi = std::make_shared<const Volume<float>>(std::move(phi));
    return;
  }
  result.wall.emplace();
  if (evidence != nullptr) closeHandles(phi, *evidence, result, warnings, progress.sub(0.0, 0.1));
  result.voxelwise = std::make_shared<const Volume<float>>(std::move(phi));
  SmoothWall wall = smoothWallDistance(*result.voxelwise, evidence, params, progress.sub(0.1, 1.0));
  if (wall.spreadVoxels >= kScanner) result.voxelwise = nullptr;
  result.wall->spreadVoxels = wall.spreadVoxels;
  result.wall->heldVoxels = wall.heldVoxels;
  result.phi = std::make_shared<const Volume<float>>(std::move(wall.phi));
}

Volume<float> smoothMask(Volume<float> phi, const SmoothWallParams& params,
                         const Progress& progress) {
  if (!params.enabled) return phi;
  return smoothWallDistance(std::move(phi), nullptr, params, progress).phi;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/preview/box_preview.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/pipeline/evolve_step.h"
#include "core/pipeline/vesselness_step.h"

namespace angiomesh {
namespace {

/// Voxels around the box: what the wall is placed by lies so near, and the front there has come to
/// rest as in the whole volume.
constexpr int kMargin = 8;
/// Beyond the wall, mm in units of a working voxel: where phi is clamped.
constexpr double kFarVoxels = 5.0;

std::shared_ptr<const VesselnessResult> croppedVessels(const VesselnessResult& whole,
                                                       const VoxelBox& box) {
  auto part = std::make_shared<VesselnessResult>(whole);
  part->multiScale = std::make_shared<const Volume<float>>(cropped(*whole.multiScale, box));
  return part;
}

/// The voxels of the part's outer faces, in space, that lie in vessels that are known.
std::vector<Eigen::Vector3d> entries(const Volume<float>& known, const VoxelBox& box) {
  std::vector<Eigen::Vector3d> places;
  const auto visit = [&](int i, int j, int k) {
    if (known.at(i, j, k) < 0.0F)
      places.push_back(known.geometry.toPhysical(Eigen::Vector3d(i, j, k)));
  };
  for (int k = box.low[2]; k <= box.high[2]; ++k)
    for (int j = box.low[1]; j <= box.high[1]; ++j) {
      const bool face = k == box.low[2] || k == box.high[2] || j == box.low[1] || j == box.high[1];
      for (int i = box.low[0]; i <= box.high[0]; i += face ? 1 : box.high[0] - box.low[0])
        visit(i, j, k);
    }
  return places;
}

EvolveResult nothingIn(const Geometry& grid) {
  EvolveResult empty;
  empty.phi =
      std::make_shared<const Volume<float>>(grid, static_cast<float>(kFarVoxels * grid.voxelMm()));
  empty.converged = true;
  empty.stopReason = StopReason::Converged;
  return empty;
}

}  // namespace

EvolveResult previewInBox(const PreviewGround& ground, const VoxelBox& box,
                          const Parameters& params, const RunOptions& options,
                          const Progress& progress) {
  const Geometry& grid = ground.image->geometry;
  const VoxelBox wide = box.widened(kMargin, grid);
  Parameters inBox = params;
  const Thresholds whole = thresholdsFor(*ground.vessels, params.thresholds);
  inBox.thresholds.b = whole.b;
  progress.check();
  const Volume<float> image = cropped(*ground.image, wide);
  SeedsResult seeds;
  for (const Eigen::Vector3d& seed : ground.seedsLps)
    if (image.geometry.holds(seed)) seeds.pointsLps.push_back(seed);
  if (ground.known && ground.known->geometry == grid)
    for (const Eigen::Vector3d& place : entries(*ground.known, wide))
      seeds.pointsLps.push_back(place);
  std::vector<std::string> warnings;
  EvolveResult result;
  try {
    result = makeSegmentation(image, croppedVessels(*ground.vessels, wide), seeds, inBox, options,
                              progress, warnings);
  } catch (const NumericError&) {
    // No vesselness in the part, or the front shrank to nothing: there is no vessel here.
    result = nothingIn(image.geometry);
  }
  result.thresholds = whole;
  result.phi = std::make_shared<const Volume<float>>(cropped(*result.phi, box.seenFrom(wide)));
  result.voxelwise.reset();
  return result;
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/segmentation_mask.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/pipeline/segments.h"
#include "core/quality/overlap.h"

namespace angiomesh {
namespace {

void requireSegmentation(const RunResult& result) {
  if (!result.segmentation())
    throw InputError("there is no segmentation yet", "mask", "run the step evolve first");
}

/// What phi rises by where a component was left out or a cut ends a vessel, at least, working
/// voxels.
constexpr float kTaken = 0.05F;

double levelMm(const RunResult& result, const Geometry& grid) {
  const Parameters& p = result.params;
  const Geometry& g = result.segmentation()->phi->geometry;
  const bool placed = p.segmentation.method == SegmentationMethod::LevelSet && p.lumen.enabled;
  const bool same = g.spacing.isApprox(grid.spacing, 1e-6);
  const bool ofVoxels = result.segmentation()->voxelwise || !result.segmentation()->wall;
  return placed && ofVoxels && !same ? std::max(0.5 - p.lumen.level, 0.0) * g.voxelMm() : 0.0;
}

}  // namespace

Volume<std::uint8_t> segmentationMask(const RunResult& result, const Volume<float>& phi,
                                      const Geometry& grid) {
  requireSegmentation(result);
  const double level = levelMm(result, grid);
  if (!result.segmentation()->voxelwise) return maskOnGrid(phi, grid, level);
  const Volume<float>& smooth = *result.segmentation()->phi;
  Volume<float> mask = *result.segmentation()->voxelwise;
  const float taken = kTaken * static_cast<float>(phi.geometry.voxelMm());
  parallelForEach(mask.voxels.size(), 1 << 16, [&](std::size_t i) {
    if (phi.voxels[i] > smooth.voxels[i] + taken)
      mask.voxels[i] = std::max(mask.voxels[i], phi.voxels[i]);
  });
  return maskOnGrid(mask, grid, level);
}

Volume<std::uint8_t> segmentationMask(const RunResult& result, const Geometry& grid) {
  requireSegmentation(result);
  return segmentationMask(result, *keptPhi(result), grid);
}

}  // namespace angiomesh

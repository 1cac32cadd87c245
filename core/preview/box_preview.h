// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/image/voxel_box.h"
#include "core/pipeline/run_options.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// What a preview starts from: results that are at hand, on one grid.
struct PreviewGround {
  std::shared_ptr<const Volume<float>> image;  ///< preprocessed
  std::shared_ptr<const VesselnessResult> vessels;
  std::vector<Eigen::Vector3d> seedsLps;
  /// phi of a segmentation, for vessels that only pass through the box; null: there is none.
  std::shared_ptr<const Volume<float>> known;
};

/// The segmentation of a part of the volume that the parameters of the step evolve would give, on
/// the voxels of the box. Thresholds are those of the whole volume, and the evolution runs on a
/// margin around the box, too. A vessel that reaches the margin's border is found if it belongs to
/// `known` there, is large enough in the box (levelset.floodLeastVoxels) or holds a seed.
/// Where nothing is left, phi is positive all over.
/// @pre segmentation.method is the level set
/// @throws InputError, NumericError (no vesselness at all), Cancelled
EvolveResult previewInBox(const PreviewGround& ground, const VoxelBox& box,
                          const Parameters& params, const RunOptions& options,
                          const Progress& progress);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/base/progress.h"
#include "core/corrections/correction.h"
#include "core/image/voxel_box.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

/// What corrections look at besides the segmentation.
struct CorrectionGround {
  const Volume<float>* image = nullptr;  ///< preprocessed, on phi's grid; null of a segmentation
  VesselnessParams vesselness;           ///< its polarity, and what bridges are found with
};

/// A segmentation with a correction made.
struct Corrected {
  Volume<float> phi;
  /// Of all voxels whose phi changed; of no meaning where nothing did.
  VoxelBox box;
  std::size_t added = 0, removed = 0;  ///< voxels that changed sides

  [[nodiscard]] bool nothing() const { return added == 0 && removed == 0; }
};

/// Corrects phi, a signed distance in mm clamped at 5 working voxels, as the result's phi is. What
/// is farther than that from the change stays the same bits. The same for any number of threads.
/// @throws InputError where the correction cannot be made, Cancelled
Corrected applyCorrection(const Volume<float>& phi, const Correction& correction,
                          const CorrectionGround& ground, const Progress& progress = {});

}  // namespace angiomesh

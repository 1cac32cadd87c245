// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/step_results.h"

namespace angiomesh {

/// What a voxel of the working grid looks like at one scale.
struct VoxelAtScale {
  double sigmaMm = 0.0;
  std::array<double, 3> eigenvalues{};  ///< of the Hessian times sigma^2, by rising magnitude
  double vesselness = 0.0;
};

/// All that the level set method goes by at one voxel.
struct VoxelReason {
  Index3 voxel{0, 0, 0};  ///< of the working grid
  double value = 0.0;     ///< of the preprocessed image
  double phiMm = 0.0;     ///< negative inside
  bool leftOut = false;   ///< inside the segmentation, but of a part that was not kept
  std::vector<VoxelAtScale> scales;
  std::size_t best = 0;  ///< the scale of the largest magnitude, which is the vesselness
  Thresholds thresholds;
  double p = 0.0;              ///< eq. 3.21
  double curvature = 0.0;      ///< kappa of phi, 1 / working voxel
  double curvatureTerm = 0.0;  ///< (1 - gamma) |d kappa|
  double speed = 0.0;          ///< F = gamma p + (1 - gamma) |d kappa|: outwards where positive
  /// Mean of the image inside and outside, within 6 voxels; empty where there is none.
  std::optional<double> lumen, surroundings;

  [[nodiscard]] double vesselness() const { return scales[best].vesselness; }
  [[nodiscard]] bool inside() const { return phiMm < 0.0 && !leftOut; }
  /// How far the value lies from the surroundings (0) to the lumen (1); empty without both.
  [[nodiscard]] std::optional<double> brightness() const;
  /// Why the voxel is vessel or not, in a sentence or two.
  [[nodiscard]] std::string text(const Parameters& params) const;
};

/// @param params those of the results   @param keptPhi of the parts that were kept; may be null
/// @throws InputError when the point lies outside the working grid, or the segmentation is not one
/// of the level set method
VoxelReason reasonAt(const Eigen::Vector3d& pointLps, const Volume<float>& image,
                     const VesselnessResult& vessels, const EvolveResult& evolve,
                     const Volume<float>* keptPhi, const Parameters& params);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

/// How a solid becomes voxels.
/// - Gaussian: the voxel's mean over its own volume (exact partial volume), blurred by a Gaussian
/// of
///   standard deviation `sigma`, in voxels of the smallest spacing: round in mm. 0: the partial
///   volume alone.
/// - Mr: an MR acquisition, k-space cut off at the sampling rate and weighted by a Hamming window,
///   along each axis h(x) = 0.54 sinc x + 0.23 (sinc(x - 1) + sinc(x + 1)), x in acquired voxels.
///   With `zeroFilling` z the acquired voxels are z times as long as those of the image. It rings
///   by about 1 % of the contrast.
/// - Subvoxels: 2x2x2 subvoxels at 32 each, min(255, 32 n), as the literature's phantoms have them:
///   a staircase that no scanner makes.
struct PointSpread {
  enum class Kind { Gaussian, Mr, Subvoxels };
  Kind kind = Kind::Gaussian;
  double sigma = 0.5;
  double zeroFilling = 1.0;
};

/// "gaussian", "gaussian:SIGMA", "mr", "mr:ZEROFILLING" or "subvoxels".
/// @throws InputError for another word, or a number that makes no sense
PointSpread pointSpreadFromText(const std::string& text);
std::string pointSpreadText(const PointSpread& psf);

/// @throws InputError for a sigma beyond 0..4 or a zero filling beyond 1..4
void checkPointSpread(const PointSpread& psf);

/// What a source in a voxel adds to the voxels around it along one axis: the source is one of
/// `cells` equal parts of the voxel, with the value of a whole voxel filled.
struct AxisKernel {
  int reach = 0;  ///< voxels on either side
  int cells = 1;
  std::vector<double> weights;  ///< of cell c and shift s at c * (2 reach + 1) + s + reach

  [[nodiscard]] const double* of(int cell) const {
    return weights.data() + static_cast<std::size_t>(cell) * static_cast<std::size_t>(span());
  }
  [[nodiscard]] int span() const { return 2 * reach + 1; }
};

/// @param psf Gaussian or Mr
/// @param sigmaVoxels of this axis, for the Gaussian
/// @param cellWidth standard deviation, in voxels, by which the cells' values are blurred already:
/// as much less is the Gaussian
/// The weights that a voxel gets from everywhere sum to 1.
AxisKernel axisKernel(const PointSpread& psf, double sigmaVoxels, int cells, double cellWidth);

/// Whether a Gaussian is wide enough for soft cells, see partialVolumes().
bool isWide(const PointSpread& psf, const Geometry& grid);

/// Blurs voxels whose values are means over their own volumes, the border repeated; Subvoxels: as
/// it is.
void blurVoxels(Volume<float>& image, const PointSpread& psf, const Progress& progress);

}  // namespace angiomesh

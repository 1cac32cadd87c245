// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "core/base/progress.h"
#include "core/image/voxel_box.h"

namespace angiomesh {

enum class Isotropic { Auto, Off, On };

struct PreprocessParams {
  Isotropic isotropic = Isotropic::Auto;
  std::optional<double> clampLower, clampUpper;  ///< see clampIntensities(); empty: no bound
  int clampRimVoxels = 1;
  bool sigmoidEnabled = false;
  std::optional<double> sigmoidWindow;  ///< empty: from the image (1st to 99.8th percentile)
  std::optional<double> sigmoidLevel;
  bool curvatureFlowEnabled = false;
  int curvatureFlowIterations = 5;
  double curvatureFlowTimeStep = 0.0625;
  std::optional<std::array<double, 6>> roi;  ///< x0,y0,z0,x1,y1,z1 LPS mm

  bool operator==(const PreprocessParams&) const = default;
};

/// The least box of the voxels whose centres lie in the LPS box (any order of the corners). Looks
/// at rows, not at voxels.
/// @throws InputError when no voxel centre, or fewer than 2 in some direction, lies in it
VoxelBox voxelsInBox(const Geometry& geometry, const std::array<double, 6>& boxLps);

/// The voxels of voxelsInBox(). @throws as that
Volume<float> cropToBox(const Volume<float>& image, const std::array<double, 6>& boxLps);

/// To cubic voxels of the smallest spacing by cubic (Catmull-Rom) interpolation, clamped to the
/// value range.
Volume<float> resampleIsotropic(const Volume<float>& image, const Progress& progress = {});

/// Whether `auto` would resample: spacing differs by more than 10 % and the result has at most 3
/// times the voxels.
bool wantsIsotropic(const Geometry& geometry);

/// lo + (hi - lo) / (1 + exp(-(I - level) / (window / 6))), lo and hi the input's range.
Volume<float> sigmoid(const Volume<float>& image, double window, double level);

/// Takes out what is brighter than any vessel, as bone, calcium and metal are in CT: voxels above
/// `upper` and those within `rimVoxels` steps over 26-neighbours of them, whose brightness is
/// partly theirs, get the median of the other voxels between the bounds. Values below `lower` are
/// raised to it.
/// @throws InputError when nothing is left between the bounds
Volume<float> clampIntensities(const Volume<float>& image, std::optional<double> lower,
                               std::optional<double> upper, int rimVoxels);

/// Whether preprocess() would return such an image as it is.
bool leavesAlone(const PreprocessParams& params, const Geometry& geometry);

/// Region of interest, bounds of the intensity, resampling, sigmoid, curvature flow (ITK), in this
/// order.
Volume<float> preprocess(const Volume<float>& image, const PreprocessParams& params,
                         const Progress& progress = {});

}  // namespace angiomesh

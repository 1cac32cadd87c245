// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/levelset/evolution.h"
#include "core/vesselness/vesselness.h"

namespace angiomesh {

enum class SegmentationMethod {
  LevelSet,               ///< LevelSetEvolution, not made here
  GeodesicActiveContour,  ///< Caselles, Kimmel, Sapiro 1997
  ConfidenceConnected,    ///< region growing by mean and standard deviation of the region
  Threshold,
  Label  ///< the image is a segmentation already: see distanceOfMask(), not made here
};

/// Of the methods that the thesis compares itself with (chapter 5), as ITK has them.
struct ComparisonParams {
  /// phi_t = -(propagation g |grad phi| + advection grad g . grad phi - curvature g kappa |grad
  /// phi|), g = 1 / (1 + exp(-(m - beta) / alpha)), m the gradient magnitude of the image at scale
  /// gacSigmaVoxels, intensities per working voxel. Empty: with e = contrast / (sigma sqrt(2 pi)),
  /// the m of a step edge of the image's robust contrast, and n the median of m, beta = (e + n) / 2
  /// and alpha = -(e - n) / 6.
  double gacSigmaVoxels = 0.7;
  std::optional<double> gacAlpha, gacBeta;
  double gacPropagation = 1.0, gacCurvature = 0.2, gacAdvection = 4.0;
  int gacIterations = 500;
  double gacRms = 0.02;  ///< ends below this root mean square change of phi

  double confidenceMultiplier = 2.5;  ///< standard deviations on either side of the mean
  int confidenceIterations = 4;
  int confidenceRadiusVoxels = 1;  ///< of the cubes around the seeds that start the statistics

  /// Bright vessels: empty `lower` is Otsu's threshold, empty `upper` none; dark ones: the reverse.
  std::optional<double> thresholdLower, thresholdUpper;
  double thresholdSigmaVoxels = 0.7;  ///< of a Gaussian before
  bool thresholdFromSeeds = true;     ///< only the parts that hold a seed

  bool operator==(const ComparisonParams&) const = default;
};

struct ComparisonResult {
  Volume<float> phi;  ///< negative inside; right at and beside its zero set, no distance
  int iterations = 0;
  StopReason stopReason = StopReason::Converged;  ///< Converged, Limit or Stopped
  std::optional<double> lower, upper;             ///< intensities inside which a voxel was taken
};

/// Segments the image by another method than ours, from the same seeds (LPS mm). The contour starts
/// from balls of `seedRadiusVoxels` around them. `stop` is asked between iterations of the contour
/// and ends it when true. The same result for any number of threads.
/// @throws InputError without seeds, for LevelSet, and for a lower threshold above the upper
/// @throws NumericError when nothing, or everything, is inside   @throws Cancelled
ComparisonResult segmentByComparison(const Volume<float>& image, SegmentationMethod method,
                                     const std::vector<Eigen::Vector3d>& seedsLps,
                                     double seedRadiusVoxels, const ComparisonParams& params,
                                     Polarity polarity, const std::function<bool()>& stop = {},
                                     const Progress& progress = {});

}  // namespace angiomesh

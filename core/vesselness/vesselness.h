// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"

namespace angiomesh {

enum class VesselMeasure { Modified, Frangi };
enum class Polarity { Bright, Dark };
enum class ScaleRule {
  Ratio,      ///< ceil(log_1.5(sigma_max / sigma_min)) + 1
  Difference  ///< thesis eq. 5.1 in working voxels, at least 2 (1 when the ends are equal)
};
enum class ContrastRule {
  Robust,  ///< 99.9th percentile minus median
  Range    ///< maximum minus minimum
};

struct VesselnessParams {
  std::optional<double> sigmaMinMm, sigmaMaxMm;  ///< empty: 1 and 6 working voxels
  bool scalesFromImage = true;                   ///< see withScalesFromImage()
  std::optional<int> scales;                     ///< empty: by scaleRule
  ScaleRule scaleRule = ScaleRule::Ratio;
  VesselMeasure measure = VesselMeasure::Modified;
  double alpha = 0.5, beta = 0.5;
  std::optional<double> kMm;  ///< largest sigma of the negative branch; empty: 2 sigma_min
  std::optional<double> c;    ///< empty: cFraction of the contrast
  double cFraction = 1.0 / 6.0;
  ContrastRule contrast = ContrastRule::Robust;
  Polarity polarity = Polarity::Bright;

  bool operator==(const VesselnessParams&) const = default;
};

/// Scales in mm, evenly spaced in log(sigma) (thesis eq. 5.2), sigma_min first.
/// @throws InputError when sigma_max < sigma_min
std::vector<double> scalesMm(const VesselnessParams& params, const Geometry& geometry);

/// Half of the maximal second-derivative norm at which S saturates (eq. 3.15), in intensities.
double contrastC(const VesselnessParams& params, const Volume<float>& image);

/// Eigenvalues of a symmetric 3x3 matrix {xx, yy, zz, xy, xz, yz}, sorted by magnitude |l1| <= |l2|
/// <= |l3|.
std::array<double, 3> symmetricEigenvalues(const std::array<double, 6>& h);

/// Eq. 3.22 (Modified) or 3.15 (Frangi) at each voxel at one scale.
Volume<float> vesselnessAtScale(const Volume<float>& image, double sigmaMm,
                                const VesselnessParams& params, double c,
                                const Progress& progress = {});

/// The value of largest magnitude over the scales, sign kept; in [-1, 1].
Volume<float> vesselness(const Volume<float>& image, const VesselnessParams& params,
                         const Progress& progress = {});

}  // namespace angiomesh

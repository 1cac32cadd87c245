// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/image/volume.h"

namespace angiomesh {

/// a, b of eq. 3.20-3.21 and where they come from.
struct Thresholds {
  double a = 0.0, b = 0.0;
  double vAverage = 0.0;  ///< mean of the positive vesselness values over the voxels with v > 0
  bool clamped = false;
};

enum class ThresholdRule {
  Contrast,  ///< b = 0.007 xi: c has already scaled the vesselness by the contrast of the image
  Average    ///< eq. 3.20: b = xi * v_avg / (sigma_max / sigma_min), clamped to [bMin, bMax]
};

struct ThresholdParams {
  double xi = 20.0;
  std::optional<double> b;  ///< empty: by bRule
  ThresholdRule bRule = ThresholdRule::Contrast;
  double bMin = 0.05, bMax = 0.15;

  bool operator==(const ThresholdParams&) const = default;
};

/// b by the rule, or as given; a = 2 b. `sigmaRatio` is sigma_max / sigma_min.
/// @throws NumericError when no voxel has positive vesselness
Thresholds thresholds(const Volume<float>& vesselness, const ThresholdParams& params,
                      double sigmaRatio);

/// p of eq. 3.21: 1 above a, linear to 0 at b, linear to -1 at 0, -1 below.
double vesselSpeed(double v, const Thresholds& t);

}  // namespace angiomesh

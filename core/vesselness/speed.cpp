// SPDX-License-Identifier: BSD-3-Clause
#include "core/vesselness/speed.h"

#include <algorithm>

#include "core/base/error.h"

namespace angiomesh {

Thresholds thresholds(const Volume<float>& vesselness, const ThresholdParams& params,
                      double sigmaRatio) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const float v : vesselness.voxels)
    if (v > 0.0F) {
      sum += static_cast<double>(v);
      ++count;
    }
  if (count == 0)
    throw NumericError("no voxel looks like a vessel (no positive vesselness)", "vesselness",
                       "check the polarity (vesselness.polarity) and the range of vessel sizes "
                       "(vesselness.sigmaMinMm, vesselness.sigmaMaxMm)");
  Thresholds t;
  t.vAverage = sum / static_cast<double>(count);
  if (params.b) {
    t.b = *params.b;
  } else if (params.bRule == ThresholdRule::Contrast) {
    // Vascular trees are segmented best at 0.12 to 0.15 whatever their noise, scans at 0.10 to
    // 0.135.
    t.b = std::min(0.007 * params.xi, 0.5);
  } else {
    const double printed = params.xi * t.vAverage / sigmaRatio;
    t.b = std::clamp(printed, params.bMin, params.bMax);
    t.clamped = t.b != printed;
  }
  t.a = 2.0 * t.b;
  return t;
}

double vesselSpeed(double v, const Thresholds& t) {
  if (v >= t.a) return 1.0;
  if (v >= t.b) return (v - t.b) / (t.a - t.b);
  if (v >= 0.0) return v / t.b - 1.0;
  return -1.0;
}

}  // namespace angiomesh

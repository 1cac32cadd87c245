// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/sizing/guidance_field.h"
#include "core/sizing/sizing.h"

// The first half of the guidance field: which cells the zero set passes through, sample points on
// it, and how long edges want to be there.

namespace angiomesh {

/// What of the sizing parameters and the grid the ideal length is made of.
class IdealLength {
 public:
  IdealLength(const SplineField& field, const SizingParams& params);

  /// After the factor 1/eta and all limits, mm. `thickness(enough)`, of the vessel there, is asked
  /// for where it may limit; from `enough` on it does not.
  template <class Thickness>
  [[nodiscard]] double at(double kappaMax, Thickness thickness) const {
    const double length = fromCurvature(kappaMax);
    return limited(around_ > 0.0 ? std::min(length, around_ * thickness(length / around_))
                                 : length);
  }
  /// As at(), before thickness and the limits edgeMinMm and edgeMaxMm.
  [[nodiscard]] double fromCurvature(double kappaMax) const;
  [[nodiscard]] double limited(double lengthMm) const;
  [[nodiscard]] double longest() const { return longest_; }

 private:
  double chord_ = 0.0;   ///< length at a curvature of 1/mm
  double around_ = 0.0;  ///< length in a tube 1 mm thick, 0 without the limit edgesAround
  double shortest_ = 0.0, longest_ = 0.0;
  double resolved_ = 0.0;  ///< curvature asks for no shorter edge, but in sharp bends
  double edgeMin_ = 0.0, edgeMax_ = 0.0;
};

/// One cell of the grid that holds samples.
struct SurfaceCell {
  Index3 first;  ///< its lowest corner
  std::uint32_t firstSample = 0;
  std::uint32_t sampleCount = 0;
};

struct SurfaceSamples {
  std::vector<SurfaceCell> cells;              ///< in the grid's order
  std::vector<GuidanceField::Sample> samples;  ///< cell after cell
};

/// But for those beyond the sections of `away` (may be null). The same for any number of threads.
/// @throws Cancelled
SurfaceSamples sampleZeroSet(const SplineField& field, const IdealLength& ideal,
                             const CutAway* away, const Progress& progress);

/// Area of the polygons that the zero set of the linear interpolant cuts out of the six tetrahedra
/// of a cell (Kuhn's division), from the values at its corners (bit 0 of the number: x).
double zeroSetArea(const std::array<double, 8>& corner, const Eigen::Matrix3d& indexToPhysical);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/field/spline_field.h"
#include "core/phantom/phantom.h"

// Measures of a segmentation against the walls and centre lines that a phantom knows exactly.

namespace angiomesh {

/// A point of a zero set and how far it is outside (positive) the true wall.
struct WallSample {
  Eigen::Vector3d point;  ///< LPS mm
  double signedDistanceMm = 0.0;
  double radiusMm = 0.0;  ///< of the centre line whose wall is nearest; 0 without centre lines
};

/// Samples of the zero set of `phi`: the crossings of the grid's edges, moved onto phi = 0. In the
/// order of memory, the same for any number of threads.
/// @param distanceMm signed distance to the true wall, negative inside, at a point in LPS mm; may
/// be called from several threads
std::vector<WallSample> wallSamples(const SplineField& phi,
                                    const std::function<double(const Eigen::Vector3d&)>& distanceMm,
                                    const std::vector<CentreLineSegment>& centreLines = {},
                                    const Progress& progress = {});

/// Of the absolute distances of all samples; NaN without samples.
struct WallDistance {
  double meanMm = 0.0, percentile95Mm = 0.0;
};
WallDistance wallDistance(const std::vector<WallSample>& samples);

/// Mean signed distance of the samples whose radius is in [from, to), mm: positive where vessels
/// came out too thick. Samples farther than `reachMm` from any wall, of false vessels, do not
/// count. NaN without samples.
double wallBias(const std::vector<WallSample>& samples, double fromMm, double toMm, double reachMm);

/// sqrt(V / (pi length)), V the volume of phi < 0 around the middle `share` of the straight line
/// from - to, within `aroundMm` of it; mm. By 4 x 4 x 4 samples of each cell that the wall may
/// cross.
double tubeRadius(const SplineField& phi, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  double aroundMm, double share = 0.8);

/// The same of an image whose values are the shares (0..1) of each voxel that are inside.
double tubeRadiusOfShares(const Volume<float>& shares, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to, double aroundMm, double share = 0.8);

/// Share (0..1) of the centre lines' length, where the radius is at least `leastRadiusMm`, with phi
/// < 0 (trilinear). NaN when no centre line is so thick.
double centreLineRecall(const Volume<float>& phi, const std::vector<CentreLineSegment>& centreLines,
                        double leastRadiusMm);

struct ComponentMeasures {
  std::size_t components = 0;     ///< of the result, 26-connected
  std::size_t falseOnes = 0;      ///< those that hold no voxel of the truth
  std::size_t largestFalse = 0;   ///< voxels
  std::size_t mergedVessels = 0;  ///< pairs of vessels (centre lines from different roots) in one
};

/// @throws InputError when the masks are on different grids
ComponentMeasures measureComponents(const Volume<std::uint8_t>& result,
                                    const Volume<std::uint8_t>& truth,
                                    const std::vector<CentreLineSegment>& centreLines);

}  // namespace angiomesh

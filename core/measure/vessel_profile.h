// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/skeleton.h"
#include "core/measure/measurement.h"

namespace angiomesh {

/// The branch that a place lies in, from end to end, and the way from place to place along the
/// centre lines. About a working voxel from point to point.
/// @throws InputError where there is no vessel, and where no vessel leads from one to the other
std::vector<SkeletonPoint> branchAt(const Skeleton& skeleton, const SplineField& wall,
                                    const Eigen::Vector3d& placeLps);
std::vector<SkeletonPoint> wayBetween(const Skeleton& skeleton, const SplineField& wall,
                                      const Eigen::Vector3d& fromLps, const Eigen::Vector3d& toLps);

/// The vessel across a way, section by section.
struct VesselProfile {
  std::vector<ProfilePoint> points;  ///< the narrowest, the first and the last among them
  CrossSection narrowest;            ///< by its least diameter
  CrossSection first, last;
};

/// Sections across a centre line at each of its points. Left out are those that the border of the
/// volume slices, and those where vessels part, which would be of more than one. Of a long way not
/// more points are told than a plot shows. The same for any number of threads.
/// @throws InputError where fewer than two sections are left; Cancelled
VesselProfile profileAlong(const SplineField& wall, const std::vector<SkeletonPoint>& way,
                           const Progress& progress = {});

/// How far a vessel is narrowed, as shares: 0 where it is as wide as its reference.
struct StenosisDegree {
  double nascet = 0.0;  ///< 1 - D / D distal, of least diameters (NASCET, Stroke 1991; 22: 711)
  double wasid = 0.0;   ///< 1 - D / D proximal (WASID: Samuels et al., AJNR 2000; 21: 643)
  double area = 0.0;    ///< 1 - A / A distal
};
/// @param measurement of the kind Stenosis, its first place proximal and its second distal
StenosisDegree stenosisDegree(const Measurement& measurement);

}  // namespace angiomesh

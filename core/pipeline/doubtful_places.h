// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/measure/review.h"
#include "core/pipeline/step_results.h"

namespace angiomesh {

/// A place of a segmentation where it may be wrong.
struct DoubtfulPlace {
  DoubtKind kind = DoubtKind::Hole;
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};  ///< mm
  double weight = 0.0;  ///< the larger the more doubtful, among those of its kind
  std::string text;     ///< a sentence with figures
};

/// At most so many of a kind are worth a look.
constexpr std::size_t kMostDoubts = 15;

/// Where the segmentation of a run may be wrong, the holes first, then necks, missed vessels and
/// islands, of each kind the most doubtful first:
/// - holes: handles of phi that are shorter than 8 voxels around, or thinner than half a voxel;
/// - necks: sections of less than 0.6 of the radius on either side, within three mean radii
///   along the branch; real stenoses are among them;
/// - missed: 26-connected parts with v >= 0.6 b, of 20 voxels and more, beyond a voxel outside the
///   wall; none where the vesselness is not at hand;
/// - islands: parts of less than 2 % of the largest one's volume, the smallest first.
/// @param phi of the parts that are kept, mm, as the evolution gave it   @throws Cancelled
std::vector<DoubtfulPlace> doubtfulPlaces(const Volume<float>& phi,
                                          const VesselnessResult* vesselness,
                                          const Thresholds& thresholds,
                                          const Progress& progress = {});

}  // namespace angiomesh

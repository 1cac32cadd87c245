// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/centreline/skeleton.h"

namespace angiomesh {

/// A plane across a vessel near its tip.
struct ProposedCut {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};          ///< centre of the section, mm
  Eigen::Vector3d outwardNormalLps{0.0, 0.0, 1.0};  ///< unit, towards the tip
  double radiusMm = 0.0;                            ///< sqrt(area / pi) of the section
  int branch = 0;
};

/// A tip without a cut.
struct UncutTip {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};
  int branch = 0;
  std::string reason;  ///< half a sentence in words: "the branch is too short: ..."
};

struct EndCuts {
  std::vector<ProposedCut> cuts;  ///< by branch, its beginning before its end
  std::vector<UncutTip> uncut;
};

/// For each vessel that ends inside the volume a cut `radiiFromTip` of its radii there before the
/// end of its centre line (which is the centre of the last ball that fits). Where vessels leave the
/// volume they are open already. No cut comes nearer to a junction than the junction is thick and
/// the vessel's radius more, nor within a radius of another cut of its branch, and none lies where
/// the vessel is more than half as thick again as its centre line says.
/// @throws InputError unless radiiFromTip is finite and at least 0
EndCuts proposeEndCuts(const Skeleton& skeleton, const SplineField& phi, double radiiFromTip);

}  // namespace angiomesh

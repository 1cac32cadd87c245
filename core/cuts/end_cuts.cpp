// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/end_cuts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// A vessel here is another one than the branch's where it is so much thicker or thinner.
constexpr double kMostUnlike = 1.5;

/// A branch seen from one of its ends.
struct Approach {
  const SkeletonBranch& branch;
  bool fromFront;

  [[nodiscard]] std::size_t size() const { return branch.points.size(); }
  [[nodiscard]] const SkeletonPoint& at(std::size_t n) const {
    return branch.points[fromFront ? n : size() - 1 - n];
  }
  [[nodiscard]] int farNode() const { return fromFront ? branch.to : branch.from; }
};

/// The first point `radii` of its own radii away from the end, and how far that is.
std::optional<std::pair<std::size_t, double>> placeOfCut(const Approach& approach, double radii) {
  double gone = 0.0;
  for (std::size_t n = 0; n < approach.size(); ++n) {
    if (n > 0) gone += (approach.at(n).pointLps - approach.at(n - 1).pointLps).norm();
    if (gone >= radii * approach.at(n).radiusMm) return std::pair{n, gone};
  }
  return std::nullopt;
}

void propose(const Skeleton& skeleton, const SplineField& phi, const Approach& approach, int number,
             double radii, EndCuts& result) {
  const auto refuse = [&](const std::string& reason) {
    result.uncut.push_back({approach.at(0).pointLps, number, reason});
  };
  const double length = approach.branch.lengthMm;
  const auto found = placeOfCut(approach, radii);
  if (!found)
    return refuse(formatted("the branch is too short: %.2f mm at a mean radius of %.2f mm", length,
                            approach.branch.meanRadiusMm));
  const SkeletonPoint& place = approach.at(found->first);
  const SkeletonNode& far = skeleton.nodes[static_cast<std::size_t>(approach.farNode())];
  const double left = length - found->second;
  double wanted = place.radiusMm;
  if (far.kind == NodeKind::Junction) wanted += far.radiusMm;
  // The other tip gets its cut at about the same distance.
  if (far.kind == NodeKind::Tip) wanted += found->second;
  if (left < wanted)
    return refuse(formatted(
        far.kind == NodeKind::Junction
            ? "the branch is too short: the cut would be %.2f mm from the middle of a "
              "junction, %.2f mm are needed"
            : "the vessel is too short: %.2f mm are left behind the cut, %.2f mm are needed",
        left, wanted));
  const std::optional<LocalVessel> vessel = vesselAt(phi, place.pointLps);
  if (!vessel || vessel->radiusMm > kMostUnlike * place.radiusMm ||
      vessel->radiusMm * kMostUnlike < place.radiusMm)
    return refuse("the vessel is too irregular there for a cut across it");
  ProposedCut cut;
  cut.pointLps = vessel->centreLps;
  cut.radiusMm = vessel->radiusMm;
  cut.branch = number;
  const std::size_t back = found->first > 0 ? found->first - 1 : 0;
  const std::size_t ahead = std::min(found->first + 1, approach.size() - 1);
  const Vector3d towards = approach.at(back).pointLps - approach.at(ahead).pointLps;
  cut.outwardNormalLps = vessel->axisAlong(towards);
  result.cuts.push_back(cut);
}

}  // namespace

EndCuts proposeEndCuts(const Skeleton& skeleton, const SplineField& phi, double radiiFromTip) {
  if (!std::isfinite(radiiFromTip) || radiiFromTip < 0.0)
    throw InputError("no such distance from the vessels' tips", "end cuts",
                     "give a number of radii, 0 or more");
  EndCuts result;
  for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
    const SkeletonBranch& branch = skeleton.branches[b];
    for (const bool fromFront : {true, false}) {
      const int node = fromFront ? branch.from : branch.to;
      if (skeleton.nodes[static_cast<std::size_t>(node)].kind != NodeKind::Tip) continue;
      propose(skeleton, phi, {branch, fromFront}, static_cast<int>(b), radiiFromTip, result);
    }
  }
  return result;
}

}  // namespace angiomesh

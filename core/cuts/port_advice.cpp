// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/port_advice.h"

#include <cmath>
#include <optional>

#include "core/base/formatted.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// Where a branch passes a section.
struct Crossing {
  std::size_t branch = 0, point = 0;  ///< between this point and the next
  bool outwards = false;
};

std::vector<Crossing> crossingsOf(const Skeleton& skeleton, const Section& section) {
  std::vector<Crossing> crossings;
  for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
    const auto& points = skeleton.branches[b].points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vector3d &p = points[i].pointLps, &q = points[i + 1].pointLps;
      const double hp = section.height(p), hq = section.height(q);
      if ((hp > 0.0) == (hq > 0.0) || !section.covers(p + hp / (hp - hq) * (q - p))) continue;
      crossings.push_back({b, i, hq > 0.0});
    }
  }
  return crossings;
}

/// Along the branch from a crossing inwards to the junction that it comes from; none where it comes
/// from no junction, or passes another section before.
std::optional<double> toJunction(const Skeleton& skeleton, const CutAway& away,
                                 const Section& section, const Crossing& crossing) {
  const SkeletonBranch& branch = skeleton.branches[crossing.branch];
  const int step = crossing.outwards ? -1 : 1;
  auto at = static_cast<int>(crossing.point) + (crossing.outwards ? 0 : 1);
  const auto end = static_cast<int>(branch.points.size());
  double length = std::fabs(section.height(branch.points[static_cast<std::size_t>(at)].pointLps));
  for (; at + step >= 0 && at + step < end; at += step) {
    const Vector3d& p = branch.points[static_cast<std::size_t>(at)].pointLps;
    const Vector3d& q = branch.points[static_cast<std::size_t>(at + step)].pointLps;
    if (away.takenAt(q)) return std::nullopt;
    length += (q - p).norm();
  }
  const auto node = static_cast<std::size_t>(crossing.outwards ? branch.from : branch.to);
  if (skeleton.nodes[node].kind != NodeKind::Junction) return std::nullopt;
  return length;
}

}  // namespace

std::vector<PortAdvice> portAdvice(const Skeleton& skeleton, const CutAway& away) {
  std::vector<PortAdvice> advice;
  for (std::size_t n = 0; n < away.sections.size(); ++n) {
    const Section& section = away.sections[n];
    const std::vector<Crossing> crossings = crossingsOf(skeleton, section);
    if (crossings.size() > 1) {
      advice.push_back({n, "passes " + std::to_string(crossings.size()) +
                               " vessels at once: its cap does not lie within one vessel"});
      continue;
    }
    if (crossings.empty()) continue;
    const auto length = toJunction(skeleton, away, section, crossings[0]);
    const double diameter = section.equivalentDiameterMm();
    if (!length || *length >= kPortDiametersToBranching * diameter) continue;
    advice.push_back(
        {n, formatted("lies %.1f of its diameters from the next branching; solvers want %.0f",
                      *length / diameter, kPortDiametersToBranching)});
  }
  return advice;
}

}  // namespace angiomesh

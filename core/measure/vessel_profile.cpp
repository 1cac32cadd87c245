// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/vessel_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/base/parallel.h"
#include "core/centreline/branch_line.h"
#include "core/measure/cross_section.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Way = std::vector<SkeletonPoint>;

constexpr std::size_t kMostPoints = 160;
/// Points of the moving mean, on either side, for the direction of a way.
constexpr std::size_t kSmoothPoints = 3;
/// A section is of one vessel where its diameter is at most so many times what rays say, which
/// look past branches.
constexpr double kMostWider = 1.15;
constexpr double kKeptPerMm = 1e4;

double kept(double mm) { return std::round(mm * kKeptPerMm) / kKeptPerMm; }

SkeletonPlace placeAt(const Skeleton& skeleton, const SplineField& wall, const Vector3d& lps) {
  const std::optional<SkeletonPlace> place = placeOnSkeleton(skeleton, wall, lps);
  if (!place)
    throw InputError("there is no centre line of a vessel", "at " + placeText(lps),
                     "choose a place inside a vessel that is longer than it is thick");
  return *place;
}

const SkeletonBranch& branchOf(const Skeleton& skeleton, int branch) {
  return skeleton.branches[static_cast<std::size_t>(branch)];
}

/// The points of a branch from one to another, both included, in this order.
void append(Way& way, const SkeletonBranch& branch, int from, int to) {
  for (int n = from;; n += from < to ? 1 : -1) {
    way.push_back(branch.points[static_cast<std::size_t>(n)]);
    if (n == to) return;
  }
}

int lastPoint(const SkeletonBranch& branch) { return static_cast<int>(branch.points.size()) - 1; }

double lengthBetween(const SkeletonBranch& branch, int from, int to) {
  return branch.lengthMm * std::abs(to - from) / std::max(1, lastPoint(branch));
}

/// The shortest ways to all nodes of a skeleton from a place in a branch (Dijkstra 1959).
struct Ways {
  std::vector<double> mm;
  std::vector<int> by;  ///< the branch by which a node is reached; -1: by the one that holds the
                        ///< place, or not at all

  Ways(const Skeleton& skeleton, const SkeletonPlace& start)
      : mm(skeleton.nodes.size(), std::numeric_limits<double>::infinity()),
        by(skeleton.nodes.size(), -1) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto reach = [&](int node, double length, int branch) {
      const auto n = static_cast<std::size_t>(node);
      if (!(length < mm[n])) return;
      mm[n] = length;
      by[n] = branch;
      open.emplace(length, node);
    };
    const SkeletonBranch& own = branchOf(skeleton, start.branch);
    reach(own.from, lengthBetween(own, 0, start.point), -1);
    reach(own.to, lengthBetween(own, start.point, lastPoint(own)), -1);
    while (!open.empty()) {
      const auto [length, node] = open.top();
      open.pop();
      if (length > mm[static_cast<std::size_t>(node)]) continue;
      for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
        const SkeletonBranch& branch = skeleton.branches[b];
        const int other = branch.from == node ? branch.to : branch.from;
        if (branch.from == node || branch.to == node)
          reach(other, length + branch.lengthMm, static_cast<int>(b));
      }
    }
  }
};

/// From a node on to the start of `ways`, the nodes passed by their branches.
Way backFrom(const Skeleton& skeleton, const Ways& ways, const SkeletonPlace& start, int node) {
  Way way;
  for (int branch = ways.by[static_cast<std::size_t>(node)]; branch >= 0;
       branch = ways.by[static_cast<std::size_t>(node)]) {
    const SkeletonBranch& passed = branchOf(skeleton, branch);
    const bool forwards = passed.from == node;
    append(way, passed, forwards ? 0 : lastPoint(passed), forwards ? lastPoint(passed) : 0);
    node = forwards ? passed.to : passed.from;
  }
  const SkeletonBranch& own = branchOf(skeleton, start.branch);
  const double along = lengthBetween(own, 0, start.point);
  const bool byFrom = own.from == node && (own.to != node || along <= 0.5 * own.lengthMm);
  append(way, own, byFrom ? 0 : lastPoint(own), start.point);
  return way;
}

/// Without points that fall on the one before, as where branches meet.
Way withoutDoubles(const Way& way) {
  Way result;
  for (const SkeletonPoint& point : way)
    if (result.empty() || (point.pointLps - result.back().pointLps).norm() > 1e-6)
      result.push_back(point);
  return result;
}

struct Cut {
  std::optional<CrossSection> section;
  double alongMm = 0.0;
};

/// Across the way at its points, where a section is of one vessel.
std::vector<Cut> cutsAlong(const SplineField& wall, const Way& way, const Progress& progress) {
  Polyline line;
  for (const SkeletonPoint& point : way) line.push_back(point.pointLps);
  const Polyline smooth = smoothed(line, kSmoothPoints);
  std::vector<Cut> cuts(way.size());
  for (std::size_t n = 1; n < way.size(); ++n)
    cuts[n].alongMm = cuts[n - 1].alongMm + (line[n] - line[n - 1]).norm();
  parallelForEach(way.size(), 1, progress, [&](std::size_t n) {
    const double voxel = wall.geometry().voxelMm();
    const auto reach = static_cast<std::size_t>(2.0 + way[n].radiusMm / voxel);
    const Vector3d axis = tangentAt(smooth, n, reach);
    try {
      const Section section = sectionOf(wall, {line[n], axis}, "the section", 2);
      if (section.equivalentDiameterMm() <= kMostWider * 2.0 * way[n].radiusMm)
        cuts[n].section = crossSectionOf(section);
    } catch (const InputError&) {
      // Sliced by the border, or off the vessel.
    }
  });
  return cuts;
}

}  // namespace

Way branchAt(const Skeleton& skeleton, const SplineField& wall, const Vector3d& placeLps) {
  return branchOf(skeleton, placeAt(skeleton, wall, placeLps).branch).points;
}

Way wayBetween(const Skeleton& skeleton, const SplineField& wall, const Vector3d& fromLps,
               const Vector3d& toLps) {
  const SkeletonPlace from = placeAt(skeleton, wall, fromLps), to = placeAt(skeleton, wall, toLps);
  const SkeletonBranch& first = branchOf(skeleton, from.branch);
  const Ways ways(skeleton, to);
  const auto by = [&](int node, int end) {
    return lengthBetween(first, from.point, end) + ways.mm[static_cast<std::size_t>(node)];
  };
  const double byFrom = by(first.from, 0), byTo = by(first.to, lastPoint(first));
  const double direct = from.branch == to.branch ? lengthBetween(first, from.point, to.point)
                                                 : std::numeric_limits<double>::infinity();
  Way way;
  if (direct <= std::min(byFrom, byTo) && std::isfinite(direct)) {
    append(way, first, from.point, to.point);
  } else {
    if (!std::isfinite(std::min(byFrom, byTo)))
      throw InputError("no vessel leads from one place to the other", "at " + placeText(toLps),
                       "choose two places of one vessel");
    append(way, first, from.point, byFrom <= byTo ? 0 : lastPoint(first));
    const Way rest = backFrom(skeleton, ways, to, byFrom <= byTo ? first.from : first.to);
    way.insert(way.end(), rest.begin(), rest.end());
  }
  return withoutDoubles(way);
}

VesselProfile profileAlong(const SplineField& wall, const Way& way, const Progress& progress) {
  std::vector<Cut> cuts = way.size() < 2 ? std::vector<Cut>() : cutsAlong(wall, way, progress);
  cuts.erase(std::remove_if(cuts.begin(), cuts.end(), [](const Cut& cut) { return !cut.section; }),
             cuts.end());
  if (cuts.size() < 2)
    throw InputError("too little of the vessel has a section of its own",
                     way.empty() ? std::string() : "at " + placeText(way.front().pointLps),
                     "choose places farther apart, away from branchings and borders");
  const auto narrowest = std::min_element(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
    return a.section->minDiameterMm() < b.section->minDiameterMm();
  });
  VesselProfile profile{{}, *narrowest->section, *cuts.front().section, *cuts.back().section};
  const std::size_t every = (cuts.size() + kMostPoints - 1) / kMostPoints;
  for (std::size_t n = 0; n < cuts.size(); ++n) {
    const CrossSection& section = *cuts[n].section;
    if (n % every != 0 && n + 1 != cuts.size() && &cuts[n] != &*narrowest) continue;
    profile.points.push_back({kept(cuts[n].alongMm), section.centreLps,
                              kept(section.equivalentDiameterMm()), kept(section.minDiameterMm()),
                              kept(section.maxDiameterMm())});
  }
  return profile;
}

StenosisDegree stenosisDegree(const Measurement& measurement) {
  const CrossSection &narrow = measurement.sections.at(0), &proximal = measurement.sections.at(1),
                     &distal = measurement.sections.at(2);
  return {1.0 - narrow.minDiameterMm() / distal.minDiameterMm(),
          1.0 - narrow.minDiameterMm() / proximal.minDiameterMm(),
          1.0 - narrow.areaMm2 / distal.areaMm2};
}

}  // namespace angiomesh

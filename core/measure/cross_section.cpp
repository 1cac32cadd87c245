// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/cross_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"
#include "core/mesh/flat_area.h"

namespace angiomesh {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Loop = std::vector<Vector3d>;

/// Of an outline that is kept, and the decimals of a mm of what is.
constexpr std::size_t kMostOutlinePoints = 60;
constexpr double kKeptPerMm = 1e4;

Vector3d kept(const Vector3d& point) {
  return (point * kKeptPerMm).array().round().matrix() / kKeptPerMm;
}

double areaOf(const Loop& loop, const Vector3d& normal) {
  FlatArea area(normal);
  for (std::size_t i = 0; i < loop.size(); ++i) area.add(loop[i], loop[(i + 1) % loop.size()]);
  return std::fabs(area.areaMm2());
}

/// The one around all others.
const Loop& outermost(const Section& section) {
  const Vector3d& normal = section.plane.normalLps;
  return *std::max_element(
      section.loops.begin(), section.loops.end(),
      [&](const Loop& a, const Loop& b) { return areaOf(a, normal) < areaOf(b, normal); });
}

double twiceArea(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Counter-clockwise (Andrew's monotone chain).
std::vector<Vector2d> convexHull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() > base + 1 && twiceArea(hull[hull.size() - 2], hull.back(), p) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

using Ends = std::array<Vector2d, 2>;

/// The least width lies across a side of the hull (Freeman & Shapira 1975).
Ends narrowestOf(const std::vector<Vector2d>& hull) {
  Ends ends{hull.front(), hull.front()};
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d& from = hull[i];
    const Vector2d side = (hull[(i + 1) % hull.size()] - from).normalized();
    const Vector2d inward(-side.y(), side.x());
    const Vector2d* farthest = &from;
    for (const Vector2d& p : hull)
      if ((p - from).dot(inward) > (*farthest - from).dot(inward)) farthest = &p;
    const double width = (*farthest - from).dot(inward);
    if (width >= least) continue;
    least = width;
    ends = {*farthest - width * inward, *farthest};
  }
  return ends;
}

Ends widestOf(const std::vector<Vector2d>& hull) {
  Ends ends{hull.front(), hull.front()};
  for (const Vector2d& a : hull)
    for (const Vector2d& b : hull)
      if ((b - a).squaredNorm() > (ends[1] - ends[0]).squaredNorm()) ends = {a, b};
  return ends;
}

Loop thinned(const Loop& loop) {
  const std::size_t count = std::min(loop.size(), kMostOutlinePoints);
  Loop result;
  for (std::size_t n = 0; n < count; ++n) result.push_back(kept(loop[n * loop.size() / count]));
  return result;
}

}  // namespace

CrossSection crossSectionOf(const Section& section) {
  const Loop& outline = outermost(section);
  const Vector3d u = section.lattice.u.normalized(), v = section.lattice.v.normalized();
  std::vector<Vector2d> flat;
  for (const Vector3d& p : outline)
    flat.emplace_back((p - section.centreLps).dot(u), (p - section.centreLps).dot(v));
  const std::vector<Vector2d> hull = convexHull(std::move(flat));
  const auto inSpace = [&](const Ends& ends) {
    return std::array<Vector3d, 2>{kept(section.centreLps + ends[0].x() * u + ends[0].y() * v),
                                   kept(section.centreLps + ends[1].x() * u + ends[1].y() * v)};
  };
  CrossSection result;
  result.centreLps = kept(section.centreLps);
  result.axisLps = section.plane.normalLps;
  result.areaMm2 = std::round(section.areaMm2 * kKeptPerMm) / kKeptPerMm;
  result.narrowest = inSpace(narrowestOf(hull));
  result.widest = inSpace(widestOf(hull));
  result.outline = thinned(outline);
  return result;
}

CrossSection crossSectionAt(const SplineField& wall, const Vector3d& placeLps) {
  const std::optional<LocalVessel> vessel = vesselAt(wall, placeLps);
  if (!vessel)
    throw InputError("there is no vessel", "at " + placeText(placeLps),
                     "choose a place inside the segmentation or on its wall");
  return crossSectionOf(sectionOf(wall, {vessel->centreLps, vessel->axisLps}, "the section"));
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "render/marks/port_drag.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// Seen this nearly end-on (cosine), a way along the vessel is no way on the screen.
constexpr double kEndOn = 0.95;
/// The centre line's direction is taken over so many points to either side.
constexpr std::size_t kReach = 3;
/// A step along the centre line may pass so many points that lie farther from the line of sight.
constexpr int kLookAhead = 4;

Vector3d meets(const ViewRay& ray, const Vector3d& point, const Vector3d& normal) {
  const double slope = ray.direction.dot(normal);
  if (std::fabs(slope) < 1e-6) return point;
  return ray.from + (point - ray.from).dot(normal) / slope * ray.direction;
}

std::size_t nearestOf(const std::vector<Vector3d>& path, const Vector3d& point) {
  const auto nearer = [&](const Vector3d& a, const Vector3d& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  };
  return static_cast<std::size_t>(std::min_element(path.begin(), path.end(), nearer) -
                                  path.begin());
}

}  // namespace

PortDrag::PortDrag(const PortMark& mark, Grip grip, double arrowMm, const ViewRay& ray)
    : mark_(mark), grip_(grip), arrowMm_(arrowMm), first_(ray) {
  grabbed_ = meets(ray, mark_.plane.pointLps, ray.direction);
  if (mark_.path.size() < 2) mark_.path.clear();
  if (mark_.path.empty()) return;
  start_ = nearestOf(mark_.path, mark_.plane.pointLps);
  at_ = start_;
  // Grabbed beside its centre the disc must not jump.
  (void)slid(ray);
  grabbedAt_ = at_;
}

CutPlane PortDrag::moved(const ViewRay& ray, bool free) {
  if (grip_ == Grip::Arrow) return tilted(ray);
  if (grip_ == Grip::Turn) return turned(ray);
  if (free || endOn()) return acrossView(ray);
  return mark_.path.empty() ? alongNormal(ray) : slid(ray);
}

bool PortDrag::endOn() const {
  const Vector3d way = mark_.path.empty() ? mark_.plane.normalLps : tangent(start_);
  return std::fabs(way.dot(first_.direction)) > kEndOn;
}

double PortDrag::distance(std::size_t point, const ViewRay& ray) const {
  return (mark_.path[point] - ray.from).cross(ray.direction).norm();
}

Vector3d PortDrag::tangent(std::size_t point) const {
  const std::size_t low = point > kReach ? point - kReach : 0;
  const std::size_t high = std::min(point + kReach, mark_.path.size() - 1);
  return (mark_.path[high] - mark_.path[low]).normalized();
}

CutPlane PortDrag::slid(const ViewRay& ray) {
  // From where it is, not the nearest of all: the vessel may pass the line of sight again.
  for (const int step : {-1, 1}) {
    int tries = 0;
    for (auto at = static_cast<std::ptrdiff_t>(at_) + step;
         at >= 0 && at < static_cast<std::ptrdiff_t>(mark_.path.size()) && tries < kLookAhead;
         at += step) {
      const auto here = static_cast<std::size_t>(at);
      ++tries;
      if (distance(here, ray) >= distance(at_, ray)) continue;
      at_ = here;
      tries = 0;
    }
  }
  const auto last = static_cast<std::ptrdiff_t>(mark_.path.size()) - 1;
  const auto off = static_cast<std::ptrdiff_t>(start_) - static_cast<std::ptrdiff_t>(grabbedAt_);
  const auto to = static_cast<std::size_t>(
      std::clamp(static_cast<std::ptrdiff_t>(at_) + off, std::ptrdiff_t{0}, last));
  if (to == start_) return mark_.plane;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(tangent(start_), tangent(to));
  return {mark_.path[to], (turn * mark_.plane.normalLps).normalized()};
}

CutPlane PortDrag::alongNormal(const ViewRay& ray) const {
  const Vector3d& normal = mark_.plane.normalLps;
  const double slope = normal.dot(first_.direction);
  const Vector3d way = acrossView(ray).pointLps - mark_.plane.pointLps;
  // Of the ways along the normal the one that looks as long on the screen.
  const Vector3d seen = normal - slope * first_.direction;
  return {mark_.plane.pointLps + way.dot(seen) / seen.squaredNorm() * normal, normal};
}

CutPlane PortDrag::acrossView(const ViewRay& ray) const {
  const Vector3d now = meets(ray, mark_.plane.pointLps, first_.direction);
  return {mark_.plane.pointLps + now - grabbed_, mark_.plane.normalLps};
}

CutPlane PortDrag::tilted(const ViewRay& ray) const {
  const Vector3d& centre = mark_.plane.pointLps;
  const Vector3d foot = ray.from + (centre - ray.from).dot(ray.direction) * ray.direction;
  const Vector3d beside = foot - centre;
  const double depth = arrowMm_ * arrowMm_ - beside.squaredNorm();
  Vector3d tip = beside;
  if (depth > 0.0) {
    // Of the two places of the tip on this line of sight that on its own side.
    const bool away = mark_.plane.normalLps.dot(ray.direction) > 0.0;
    tip += (away ? 1.0 : -1.0) * std::sqrt(depth) * ray.direction;
  }
  if (!(tip.norm() > 1e-9)) return mark_.plane;
  return {centre, tip.normalized()};
}

CutPlane PortDrag::turned(const ViewRay& ray) const {
  const CutPlane& plane = mark_.plane;
  const Vector3d& axis = first_.direction;
  const Vector3d from = grabbed_ - plane.pointLps;
  const Vector3d to = meets(ray, plane.pointLps, axis) - plane.pointLps;
  const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
  return {plane.pointLps, (Eigen::AngleAxisd(angle, axis) * plane.normalLps).normalized()};
}

}  // namespace angiomesh

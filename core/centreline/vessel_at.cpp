// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/vessel_at.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/exact_math.h"
#include "core/centreline/lumen_probe.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Ray = LumenProbe::Ray;

/// A ring of rays: so many, at angles to the plane across the vessel up to 2 x 20 degrees.
constexpr int kRingRays = 24;
constexpr int kRings = 2;
constexpr double kRingTurns = 20.0 / 360.0;

constexpr int kAxisPasses = 5;
/// Sections alike: ratio of the radii, and cosine of the angle to the line through their centres.
constexpr double kLeastAlike = 0.85;
constexpr double kLeastCosine = 0.96;

/// The end of the shortest ray that ends at the wall.
std::optional<Vector3d> nearestWall(const LumenProbe& probe, const Vector3d& from) {
  double nearest = std::numeric_limits<double>::max();
  std::optional<Vector3d> found;
  for (const Ray& ray : probe.castAround(from)) {
    if (ray.end != LumenProbe::End::Wall || ray.lengthMm >= nearest) continue;
    nearest = ray.lengthMm;
    found = from + ray.lengthMm * ray.direction;
  }
  return found;
}

/// Centre of the largest ball inside the vessel that touches its wall at `wall`.
std::optional<Vector3d> inscribedCentre(const LumenProbe& probe, const Vector3d& wall) {
  const Vector3d inward = -probe.normalAt(wall);
  const Vector3d start = wall + 0.05 * probe.voxelMm() * inward;
  if (!probe.isInside(start)) return std::nullopt;
  const Ray across = probe.cast(start, inward);
  double radius = 0.5 * across.lengthMm;
  if (across.end == LumenProbe::End::Border) radius = 0.99 * across.lengthMm;
  for (int pass = 0; pass < 20; ++pass) {
    const Vector3d centre = wall + radius * inward;
    const std::optional<Vector3d> other = nearestWall(probe, centre);
    if (!other) break;
    const Vector3d chord = *other - wall;
    if ((*other - centre).norm() > 0.97 * radius) break;
    // The ball that touches at `wall` and goes through the other point.
    const double touching = 0.5 * chord.squaredNorm() / std::max(chord.dot(inward), 1e-9);
    radius = std::clamp(touching, 0.3 * radius, 0.97 * radius);
  }
  return wall + radius * inward;
}

/// The direction that the wall's normals at the ends of the rays avoid.
class WallNormals {
 public:
  void add(const LumenProbe& probe, const Vector3d& from, const Ray& ray, double weight) {
    const Vector3d normal = probe.normalAt(from + ray.lengthMm * ray.direction);
    sum_ += weight * normal * normal.transpose();
  }
  [[nodiscard]] Vector3d axis() const {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum_).eigenvectors().col(0);
  }

 private:
  Eigen::Matrix3d sum_ = Eigen::Matrix3d::Zero();
};

double nearness(double nearest, double distance) {
  const double ratio = std::min(nearest / distance, 1.0);
  return ratio * ratio * ratio * ratio;
}

Vector3d roughAxis(const LumenProbe& probe, const Vector3d& centre) {
  const std::vector<Ray> rays = probe.castAround(centre);
  double nearest = std::numeric_limits<double>::max();
  for (const Ray& ray : rays) nearest = std::min(nearest, ray.lengthMm);
  WallNormals normals;
  for (const Ray& ray : rays)
    if (ray.end == LumenProbe::End::Wall)
      normals.add(probe, centre, ray, nearness(nearest, ray.lengthMm));
  return normals.axis();
}

/// Rays in pairs at mirrored angles to the section, so that the bend of a curved vessel cancels.
Vector3d refinedAxis(const LumenProbe& probe, const LumenSection& section, const Vector3d& axis) {
  const Plane plane(axis);
  WallNormals normals;
  for (int n = 0; n < kRingRays; ++n) {
    const double turns = static_cast<double>(n) / kRingRays;
    const Vector3d across = portableCosTurns(turns) * plane.u + portableSinTurns(turns) * plane.v;
    for (int ring = 0; ring <= kRings; ++ring) {
      const double cosine = portableCosTurns(ring * kRingTurns);
      const double sine = portableSinTurns(ring * kRingTurns);
      const Ray ahead = probe.cast(section.centreLps, cosine * across + sine * axis);
      const Ray back = probe.cast(section.centreLps, cosine * across - sine * axis);
      if (ahead.end != LumenProbe::End::Wall || back.end != LumenProbe::End::Wall) continue;
      const double distance = std::max(ahead.lengthMm, back.lengthMm) * cosine;
      const double weight = nearness(section.radiusMm, distance);
      normals.add(probe, section.centreLps, ahead, weight);
      normals.add(probe, section.centreLps, back, weight);
    }
  }
  return normals.axis();
}

/// From the section one radius behind to the one ahead, where these are alike: less sensitive to
/// rough walls than their normals are.
std::optional<Vector3d> chordAxis(const LumenProbe& probe, const LumenSection& section,
                                  const Vector3d& axis) {
  const double reach = std::max(section.radiusMm, 1.5 * probe.voxelMm());
  const auto behind = probe.section(section.centreLps - reach * axis, axis);
  const auto ahead = probe.section(section.centreLps + reach * axis, axis);
  for (const auto* other : {&behind, &ahead}) {
    if (!*other) return std::nullopt;
    const double ratio = (*other)->radiusMm / section.radiusMm;
    if (ratio < kLeastAlike || ratio > 1.0 / kLeastAlike) return std::nullopt;
  }
  const Vector3d chord = (ahead->centreLps - behind->centreLps).normalized();
  if (chord.dot(axis) < kLeastCosine) return std::nullopt;
  return chord;
}

Vector3d withSign(const Vector3d& axis) {
  int greatest = 0;
  axis.cwiseAbs().maxCoeff(&greatest);
  return axis[greatest] < 0.0 ? Vector3d(-axis) : axis;
}

}  // namespace

Vector3d LocalVessel::axisAlong(const Vector3d& direction) const {
  return axisLps.dot(direction) < 0.0 ? Vector3d(-axisLps) : axisLps;
}

Vector3d LocalVessel::wayOn(const Vector3d& ahead) const {
  constexpr double sameWay = 0.5;  // cosine
  const Vector3d axis = axisAlong(ahead);
  return axis.dot(ahead) > sameWay ? axis : ahead;
}

std::optional<LocalVessel> vesselAt(const SplineField& phi, const Vector3d& pointLps,
                                    double reachVoxels) {
  const LumenProbe probe(phi);
  Vector3d point = probe.intoVolume(pointLps);
  const double reach = reachVoxels * probe.voxelMm();
  if ((point - pointLps).norm() > reach) return std::nullopt;
  std::optional<Vector3d> wall;
  if (probe.isInside(point)) {
    wall = nearestWall(probe, point);
  } else if (phi.valueAt(point) <= reach && phi.projectToZero(point, 2.0 * reachVoxels)) {
    wall = probe.intoVolume(point);
  }
  if (!wall) return std::nullopt;
  std::optional<Vector3d> centre = inscribedCentre(probe, *wall);
  if (!centre) return std::nullopt;
  const double ballRadius = (*centre - *wall).norm();
  LocalVessel vessel;
  vessel.axisLps = roughAxis(probe, *centre);
  vessel.centreLps = *centre;
  const auto findSection = [&] {
    // The ball touches the wall beside the point, but at a tip it is the ball's place that counts.
    const double along = vessel.axisLps.dot(point - vessel.centreLps);
    const Vector3d beside = probe.intoVolume(vessel.centreLps + along * vessel.axisLps);
    const bool near = std::fabs(along) < 0.5 * std::max(ballRadius, vessel.radiusMm);
    const std::optional<LumenSection> section =
        probe.section(near && probe.isInside(beside) ? beside : vessel.centreLps, vessel.axisLps);
    if (section) {
      vessel.centreLps = section->centreLps;
      vessel.radiusMm = section->radiusMm;
      vessel.inscribedMm = section->inscribedMm;
    }
    return section;
  };
  for (int pass = 0; pass < kAxisPasses; ++pass) {
    const std::optional<LumenSection> section = findSection();
    if (!section) return std::nullopt;
    const Vector3d before = vessel.axisLps;
    vessel.axisLps = refinedAxis(probe, *section, before);
    if (vessel.axisLps.cross(before).norm() < 2e-3) break;
  }
  for (int pass = 0; pass < 2; ++pass) {
    const std::optional<LumenSection> section = findSection();
    if (!section) return std::nullopt;
    vessel.axisLps = chordAxis(probe, *section, vessel.axisLps).value_or(vessel.axisLps);
  }
  findSection();
  vessel.axisLps = withSign(vessel.axisLps);
  return vessel;
}

}  // namespace angiomesh

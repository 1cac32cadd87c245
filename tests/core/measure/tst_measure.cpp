// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>
#include <vector>

#include "core/distance/mask_distance.h"
#include "core/field/wall_field.h"
#include "core/measure/cross_section.h"
#include "core/measure/vessel_profile.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/refusal.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

SplineField wallOf(const Volume<float>& phi) {
  return wallField(phi, SplineKind::InterpolatingBspline);
}

/// What is measured in.
struct Ground {
  explicit Ground(const Volume<float>& phi) : wall(wallOf(phi)), skeleton(skeletonOf(phi)) {}
  SplineField wall;
  Skeleton skeleton;
};

/// A vessel of 3.2 mm before a narrowing to 1.2 mm and of 2.4 mm behind it, along an oblique axis
/// of an oblique grid of anisotropic voxels. Radii, at a distance along from the narrowing.
struct Narrowed {
  Geometry grid = shapes::obliqueGeometry({70, 60, 90});
  Vector3d centre = analytic::centreOf(grid);
  Vector3d axis = (grid.direction * Vector3d(0.25, -0.2, 1.0)).normalized();

  static double radiusAt(double along) {
    const double step = 0.5 + 0.5 * std::tanh(along / 2.0);
    const double wide = 3.2 + (2.4 - 3.2) * step;
    return wide - (2.8 - 1.2) * std::exp(-along * along / 12.0);
  }
  [[nodiscard]] double distance(const Vector3d& p) const {
    const double along = (p - centre).dot(axis);
    const double slope = (radiusAt(along + 1e-3) - radiusAt(along - 1e-3)) / 2e-3;
    return analytic::tube(p, centre, axis, radiusAt(along)) / std::hypot(1.0, slope);
  }
  [[nodiscard]] Volume<float> phi() const {
    return analytic::clamped(grid, [this](const Vector3d& p) { return distance(p); });
  }
  [[nodiscard]] Vector3d at(double along) const { return centre + along * axis; }
};

Section flatSection(const std::vector<Eigen::Vector2d>& corners) {
  Section section;
  section.plane = {{5.0, 6.0, 7.0}, Vector3d::UnitZ()};
  section.centreLps = section.plane.pointLps;
  section.areaMm2 = 1.0;
  section.loops.resize(2);
  for (const Eigen::Vector2d& c : corners) {
    section.loops[1].push_back(section.centreLps + Vector3d(c.x(), c.y(), 0.0));
    section.loops[0].push_back(section.centreLps + Vector3d(0.1 * c.x(), 0.1 * c.y(), 0.0));
  }
  return section;
}

}  // namespace

class TestMeasure : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tubesAreCutAcross_data() {
    QTest::addColumn<Vector3d>("axis");
    QTest::addColumn<bool>("mirrored");
    QTest::newRow("along an axis of the grid") << Vector3d(0.0, 0.0, 1.0) << false;
    QTest::newRow("oblique") << Vector3d(0.3, -0.5, 0.8) << false;
    QTest::newRow("oblique, mirrored") << Vector3d(0.9, 0.4, -0.6) << true;
  }
  void tubesAreCutAcross() {
    QFETCH(Vector3d, axis);
    QFETCH(bool, mirrored);
    const Geometry g = shapes::obliqueGeometry({40, 36, 30}, mirrored);
    const Vector3d centre = analytic::centreOf(g), along = (g.direction * axis).normalized();
    const double radius = 2.1;
    const SplineField wall = wallOf(analytic::clamped(
        g, [&](const Vector3d& p) { return analytic::tube(p, centre, along, radius); }));
    // Inside beside the axis, on the wall, and a little off it.
    for (const double off : {1.0, 2.1, 2.6}) {
      const CrossSection section = crossSectionAt(wall, centre + off * along.unitOrthogonal());
      QVERIFY(isNear(section.areaMm2 / (shapes::pi * radius * radius), 1.0, 0.01));
      QVERIFY(isNear(section.equivalentDiameterMm(), 2.0 * radius, 0.02));
      QVERIFY(isNear(section.minDiameterMm(), 2.0 * radius, 0.04));
      QVERIFY(isNear(section.maxDiameterMm(), 2.0 * radius, 0.04));
      QVERIFY(isNear(std::abs(section.axisLps.dot(along)), 1.0, 1e-4));
      QVERIFY(analytic::tube(section.centreLps, centre, along, 0.0) < 0.02);
      QVERIFY(section.outline.size() > 20 && section.outline.size() <= 60);
      for (const Vector3d& p : section.outline)
        QVERIFY(isNear(analytic::tube(p, centre, along, radius), 0.0, 0.03));
    }
    QVERIFY(messageOf([&] {
              (void)crossSectionAt(wall, centre + 5.0 * along.unitOrthogonal());
            }).find("there is no vessel") == 0);
  }

  void ellipsesHaveTheirAxesAsDiameters() {
    const Geometry g = shapes::obliqueGeometry({56, 48, 36});
    const Vector3d centre = analytic::centreOf(g);
    const Vector3d axis = (g.direction * Vector3d(0.2, 0.3, 1.0)).normalized();
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    const double a = 4.4, b = 2.6;
    const SplineField wall = wallOf(analytic::clamped(g, [&](const Vector3d& p) {
      const double x = (p - centre).dot(u), y = (p - centre).dot(v);
      const double f = std::hypot(x / a, y / b);
      const double slope = std::hypot(x / (a * a), y / (b * b)) / std::max(f, 1e-6);
      return (f - 1.0) / std::max(slope, 1.0 / a);
    }));
    const CrossSection section = crossSectionAt(wall, centre + 0.5 * u);
    QVERIFY(isNear(section.areaMm2 / (shapes::pi * a * b), 1.0, 0.01));
    QVERIFY(isNear(section.equivalentDiameterMm(), 2.0 * std::sqrt(a * b), 0.04));
    QVERIFY(isNear(section.minDiameterMm(), 2.0 * b, 0.06));
    QVERIFY(isNear(section.maxDiameterMm(), 2.0 * a, 0.06));
    const Vector3d across = (section.narrowest[1] - section.narrowest[0]).normalized();
    const Vector3d along = (section.widest[1] - section.widest[0]).normalized();
    QVERIFY(std::abs(across.dot(v)) > 0.995 && std::abs(along.dot(u)) > 0.995);
    QVERIFY(((section.widest[0] + section.widest[1]) / 2.0 - centre).norm() < 0.1);
  }

  /// No chord through the centre is as long as a triangle's sides, or as its height.
  void callipersMeasureWidths() {
    const double h = std::sqrt(3.0) / 2.0;
    const CrossSection triangle = crossSectionOf(flatSection({{0, 0}, {4, 0}, {2, 4 * h}}));
    QVERIFY(isNear(triangle.minDiameterMm(), 4.0 * h, 1e-3));
    QVERIFY(isNear(triangle.maxDiameterMm(), 4.0, 1e-3));
    // A dent is spanned.
    const CrossSection dented =
        crossSectionOf(flatSection({{0, 0}, {3, 0}, {6, 0}, {6, 2}, {3, 0.5}, {0, 2}}));
    QVERIFY(isNear(dented.minDiameterMm(), 2.0, 1e-3));
    QVERIFY(isNear(dented.maxDiameterMm(), std::sqrt(40.0), 1e-3));
    QVERIFY((dented.outline.front() - Vector3d(5, 6, 7)).norm() < 1e-9);
    QVERIFY((dented.outline[2] - Vector3d(11, 6, 7)).norm() < 1e-9);
  }

  void masksAreMeasuredLikewise() {
    const Geometry g = shapes::obliqueGeometry({40, 36, 30});
    const Vector3d centre = analytic::centreOf(g);
    const Vector3d axis = (g.direction * Vector3d(0.3, -0.2, 0.9)).normalized();
    const double radius = 3.0;
    Volume<std::uint8_t> mask(g);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
      mask.voxels[i] = analytic::tube(voxelCentre(g, i), centre, axis, radius) < 0.0 ? 1 : 0;
    const CrossSection section = crossSectionAt(wallOf(distanceOfMask(mask).phi), centre);
    QVERIFY(isNear(section.equivalentDiameterMm(), 2.0 * radius, 0.1));
    QVERIFY(isNear(section.minDiameterMm(), 2.0 * radius, 0.3));
    QVERIFY(isNear(section.maxDiameterMm(), 2.0 * radius, 0.3));
  }

  void theNarrowestIsFoundBetweenTwoPlaces() {
    const Narrowed vessel;
    const Ground ground(vessel.phi());
    const Vector3d proximal = vessel.at(-14.0), distal = vessel.at(12.0);
    const std::vector<SkeletonPoint> way =
        wayBetween(ground.skeleton, ground.wall, proximal, distal);
    const VesselProfile profile = profileAlong(ground.wall, way);
    QVERIFY(isNear(profile.first.minDiameterMm(), 2.0 * vessel.radiusAt(-14.0), 0.08));
    QVERIFY(isNear(profile.last.minDiameterMm(), 2.0 * vessel.radiusAt(12.0), 0.08));
    QVERIFY((profile.first.centreLps - proximal).norm() < 0.5);
    QVERIFY((profile.last.centreLps - distal).norm() < 0.5);
    double least = 10.0, where = 0.0;
    for (double along = -14.0; along < 12.0; along += 0.01)
      if (vessel.radiusAt(along) < least) least = vessel.radiusAt(where = along);
    QVERIFY(isNear(profile.narrowest.minDiameterMm(), 2.0 * least, 0.08));
    QVERIFY(isNear((profile.narrowest.centreLps - vessel.centre).dot(vessel.axis), where, 0.6));
    for (const ProfilePoint& point : profile.points) {
      const double along = (point.pointLps - vessel.centre).dot(vessel.axis);
      QVERIFY(isNear(point.diameterMm, 2.0 * vessel.radiusAt(along), 0.08));
      QVERIFY(isNear(point.alongMm, along + 14.0, 0.6));
      QVERIFY(point.minDiameterMm <= point.diameterMm + 1e-3);
      QVERIFY(point.maxDiameterMm >= point.diameterMm - 0.02);
    }
    QVERIFY(profile.points.size() > 30 && profile.points.size() <= 163);

    Measurement m;
    m.kind = MeasurementKind::Stenosis;
    m.sections = {profile.narrowest, profile.first, profile.last};
    const StenosisDegree degree = stenosisDegree(m);
    QVERIFY(isNear(degree.nascet, 1.0 - least / vessel.radiusAt(12.0), 0.02));
    QVERIFY(isNear(degree.wasid, 1.0 - least / vessel.radiusAt(-14.0), 0.02));
    QVERIFY(isNear(degree.area, 1.0 - std::pow(least / vessel.radiusAt(12.0), 2), 0.02));
    QVERIFY(degree.wasid > degree.nascet + 0.05);

    // The other way round it is the same vessel.
    const VesselProfile back =
        profileAlong(ground.wall, wayBetween(ground.skeleton, ground.wall, distal, proximal));
    QVERIFY(back.narrowest.centreLps == profile.narrowest.centreLps);
    QVERIFY(isNear(back.points.back().alongMm, profile.points.back().alongMm, 1e-3));
  }

  void whereVesselsPartNothingIsMeasured() {
    const Geometry g = shapes::obliqueGeometry({80, 70, 60});
    const Vector3d fork = analytic::centreOf(g);
    const auto end = [&](double x, double y, double z) {
      return Vector3d(fork + g.direction * Vector3d(x, y, z));
    };
    const Vector3d root = end(-13.0, 0.0, -3.0), left = end(10.0, 12.0, 8.0),
                   right = end(12.0, -11.0, 6.0);
    const Ground ground(analytic::clamped(g, [&](const Vector3d& p) {
      return std::min({analytic::capsule(p, root, fork, 2.4), analytic::capsule(p, fork, left, 1.9),
                       analytic::capsule(p, fork, right, 1.5)});
    }));
    const Vector3d inLeft = 0.8 * left + 0.2 * fork, inRoot = 0.8 * root + 0.2 * fork;
    const VesselProfile through =
        profileAlong(ground.wall, wayBetween(ground.skeleton, ground.wall, inRoot, inLeft));
    QVERIFY(isNear(through.first.minDiameterMm(), 4.8, 0.1));
    QVERIFY(isNear(through.last.minDiameterMm(), 3.8, 0.1));
    const double length = (inRoot - fork).norm() + (inLeft - fork).norm();
    QVERIFY(isNear(through.points.back().alongMm, length, 1.5));
    double widest = 0.0, gap = 0.0;
    for (std::size_t n = 1; n < through.points.size(); ++n) {
      widest = std::max(widest, through.points[n].diameterMm);
      gap = std::max(gap, through.points[n].alongMm - through.points[n - 1].alongMm);
    }
    QVERIFY(isNear(widest, 4.8, 0.5));
    QVERIFY(gap > 1.0);
    // The branch alone.
    const VesselProfile branch =
        profileAlong(ground.wall, branchAt(ground.skeleton, ground.wall, inLeft));
    QVERIFY(isNear(branch.narrowest.equivalentDiameterMm(), 3.8, 0.2));
    for (const ProfilePoint& point : branch.points) QVERIFY(isNear(point.diameterMm, 3.8, 0.5));
    // From one daughter into the other the way does not go by the root.
    const std::vector<SkeletonPoint> across =
        wayBetween(ground.skeleton, ground.wall, inLeft, 0.8 * right + 0.2 * fork);
    for (const SkeletonPoint& point : across) QVERIFY((point.pointLps - root).norm() > 9.0);
  }

  void whatIsNoWayIsRefused() {
    const Geometry g = analytic::cube(48);
    const Vector3d one{14.0, 23.5, 23.5}, two{34.0, 23.5, 23.5}, axis = Vector3d::UnitZ();
    const Ground ground(analytic::clamped(g, [&](const Vector3d& p) {
      return std::min(analytic::tube(p, one, axis, 4.0), analytic::tube(p, two, axis, 4.0));
    }));
    const auto refused = [&](const Vector3d& from, const Vector3d& to) {
      return messageOf([&] { (void)wayBetween(ground.skeleton, ground.wall, from, to); });
    };
    QVERIFY(refused(one, two).find("no vessel leads") == 0);
    QVERIFY(refused(one, {24.0, 40.0, 5.0}).find("there is no centre line") == 0);
    QVERIFY(refused(one, one + 5.0 * axis).empty());
    const std::vector<SkeletonPoint> lone{ground.skeleton.branches.front().points.front()};
    QVERIFY(messageOf([&] { (void)profileAlong(ground.wall, lone); }).find("too little") == 0);
  }

  void theNumberOfThreadsChangesNothing() {
    const Narrowed vessel;
    const Ground ground(vessel.phi());
    const std::vector<SkeletonPoint> way =
        wayBetween(ground.skeleton, ground.wall, vessel.at(-10.0), vessel.at(9.0));
    const auto [one, several] =
        onOneAndSeveralThreads([&] { return profileAlong(ground.wall, way).points; });
    QVERIFY(one == several);
  }
};

QTEST_APPLESS_MAIN(TestMeasure)
#include "tst_measure.moc"

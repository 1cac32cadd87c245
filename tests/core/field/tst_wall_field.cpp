// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/field/wall_field.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using analytic::clamped;
using Eigen::Vector3d;

namespace {

struct Tube {
  double radius;
  Vector3d axis = Vector3d(0.31, -0.17, 1.0).normalized();
  Vector3d centre{15.7, 15.4, 15.6};

  [[nodiscard]] Vector3d out(const Vector3d& x) const {
    const Vector3d way = x - centre;
    return way - way.dot(axis) * axis;
  }
  [[nodiscard]] double distance(const Vector3d& x) const { return out(x).norm() - radius; }
};

Volume<float> mirrored(const Volume<float>& phi, std::size_t axis) {
  Volume<float> other = phi;
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    Index3 p = phi.geometry.indexOf(i);
    p[axis] = phi.geometry.size[axis] - 1 - p[axis];
    other.at(p[0], p[1], p[2]) = phi.voxels[i];
  }
  return other;
}

struct Fault {
  double spread = 0.0, degrees = 0.0;
};

/// Root mean square distance of the zero set from the tube, and mean angle between their normals.
Fault faultOf(const SplineField& field, const Tube& tube) {
  const Vector3d first = tube.axis.unitOrthogonal(), second = tube.axis.cross(first);
  double square = 0.0, angle = 0.0;
  constexpr int count = 4000;
  for (int n = 0; n < count; ++n) {
    const double turn = 2.399963229728653 * n;
    Vector3d x = tube.centre + (12.0 * n / count - 6.0) * tube.axis +
                 tube.radius * (std::cos(turn) * first + std::sin(turn) * second);
    if (!field.projectToZero(x)) return {1e9, 1e9};
    square += tube.distance(x) * tube.distance(x);
    const double cosine = tube.out(x).normalized().dot(field.at(x).gradient.normalized());
    angle += std::acos(std::min(1.0, cosine));
  }
  return {std::sqrt(square / count), angle / count * 180.0 / M_PI};
}

}  // namespace

class TestWallField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreads(0); }

  void thinTubesAreRound() {
    for (const double radius : {1.0, 1.3, 1.6, 2.0, 2.6, 3.2}) {
      const Tube tube{radius};
      const auto phi =
          clamped(analytic::cube(32), [&](const Vector3d& x) { return tube.distance(x); });
      const Fault now = faultOf(wallField(phi, SplineKind::InterpolatingBspline), tube);
      const bool thin = radius < 1.2;
      QVERIFY(isBelow(now.spread, thin ? 0.006 : 0.0025));
      QVERIFY(isBelow(now.degrees, thin ? 0.6 : 0.3));
      const Fault plain = faultOf(SplineField(phi, SplineKind::InterpolatingBspline), tube);
      if (radius < 1.8) QVERIFY(plain.degrees > 3.0 * now.degrees);
    }
  }

  void wideVesselsAndFlatWallsStay() {
    const Tube wide{6.0};
    const auto tube =
        clamped(analytic::cube(32), [&](const Vector3d& x) { return wide.distance(x); });
    QVERIFY(withRoundRidges(tube).voxels == tube.voxels);
    const Vector3d normal = Vector3d(0.2, 0.5, 0.9).normalized();
    const auto plane = clamped(analytic::cube(24), [&](const Vector3d& x) {
      return normal.dot(x - Vector3d(11.7, 12.2, 11.9));
    });
    QVERIFY(withRoundRidges(plane).voxels == plane.voxels);
    // The inside of a tube bends the other way.
    const auto hole =
        clamped(analytic::cube(32), [&](const Vector3d& x) { return -Tube{3.0}.distance(x); });
    const auto bent = withRoundRidges(hole);
    for (std::size_t i = 0; i < hole.voxels.size(); ++i)
      QVERIFY(std::fabs(bent.voxels[i] - hole.voxels[i]) < 0.05F);
  }

  void signsStayAndValuesRiseWithTheDistance() {
    const Tube tube{1.5};
    const auto phi =
        clamped(analytic::cube(32), [&](const Vector3d& x) { return tube.distance(x); });
    const auto round = withRoundRidges(phi);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      QCOMPARE(round.voxels[i] < 0.0F, phi.voxels[i] < 0.0F);
      QVERIFY(round.voxels[i] >= phi.voxels[i]);
      if (phi.voxels[i] >= 4.9F) QCOMPARE(round.voxels[i], phi.voxels[i]);
    }
  }

  void thePlainBsplineIsLeftAlone() {
    const Tube tube{1.5};
    const auto phi =
        clamped(analytic::cube(24), [&](const Vector3d& x) { return tube.distance(x); });
    const SplineField wall = wallField(phi, SplineKind::Bspline), plain(phi, SplineKind::Bspline);
    for (int n = 3; n < 20; ++n) {
      const Vector3d x(n, 11.3, 12.6);
      QCOMPARE(wall.valueAt(x), plain.valueAt(x));
    }
  }

  void axesAndSidesAreAlike() {
    for (const bool fewAlongLast : {false, true}) {
      const Volume<float> phi = analytic::unlikeVessels(fewAlongLast);
      const Volume<float> round = withRoundRidges(phi);
      QVERIFY(analytic::mostApart(round, phi) > 0.1 * phi.geometry.voxelMm());
      const auto isSame = [&](const Volume<float>& other, const Volume<float>& expected) {
        return analytic::mostApart(withRoundRidges(other), expected) <
               1e-5 * phi.geometry.voxelMm();
      };
      QVERIFY(isSame(analytic::turned(phi), analytic::turned(round)));
      for (std::size_t axis = 0; axis < 3; ++axis)
        QVERIFY(isSame(mirrored(phi, axis), mirrored(round, axis)));
    }
  }

  void lengthsHaveNoUnit() {
    const Tube tube{1.4};
    const auto phi =
        clamped(analytic::cube(28), [&](const Vector3d& x) { return tube.distance(x); });
    auto large = phi;
    large.geometry.spacing *= 4.0;
    for (float& value : large.voxels) value *= 4.0F;
    auto expected = withRoundRidges(phi);
    for (float& value : expected.voxels) value *= 4.0F;
    QVERIFY(withRoundRidges(large).voxels == expected.voxels);
  }

  void theResultDoesNotDependOnTheNumberOfThreads() {
    const Tube tube{1.4};
    const auto phi =
        clamped(analytic::cube(28), [&](const Vector3d& x) { return tube.distance(x); });
    setThreads(1);
    const auto one = withRoundRidges(phi);
    setThreads(3);
    QVERIFY(withRoundRidges(phi).voxels == one.voxels);
  }
};

QTEST_GUILESS_MAIN(TestWallField)
#include "tst_wall_field.moc"

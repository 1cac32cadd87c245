// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "core/openings/end_planes.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using Eigen::Vector3d;

class TestEndPlanes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Whatever angle the planes meet at: the nearest vector that lies in all of them.
  void stepsAreProjectedOntoTheirPlanes() {
    const Geometry g = analytic::oblique(20, 22, 18);
    const Vector3d step(0.3, -1.1, 0.7);
    for (const double degrees : {90.0, 60.0, 30.0, 150.0}) {
      const double turn = degrees * M_PI / 180.0;
      const Vector3d across = g.direction.col(0), up = g.direction.col(2);
      const Vector3d line = g.direction.col(1);  // of both planes
      const EndPlanes planes(
          g, {{analytic::centreOf(g), std::cos(turn) * up + std::sin(turn) * across}});
      QCOMPARE(planes.count(), 7);
      Place place = Place::inPlane(5);
      QVERIFY((planes.along(place, step) - (step - step.dot(up) * up)).norm() < 1e-12);
      place.cut = 1;
      QCOMPARE(place.planes(), 2);
      QVERIFY((planes.along(place, step) - step.dot(line) * line).norm() < 1e-12);
      QVERIFY((planes.along(place, line) - line).norm() < 1e-12);
      // In the corner of three nothing is left.
      place.borders |= 1U << 2U;
      QVERIFY(planes.along(place, step).isZero());
    }
    QVERIFY(EndPlanes(g).along(Place::onWall(), step) == step);
  }
};

QTEST_APPLESS_MAIN(TestEndPlanes)
#include "tst_end_planes.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/quality/zero_set_measure.h"
#include "core/surface/marching_cubes.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using shapes::pi;

namespace {

/// (|x - c|^2 - r^2) / 2r, a quadratic, which Catmull-Rom's cubics hold exactly.
Volume<float> quadraticBall(const Geometry& g, double radius) {
  return analytic::sampled(g, [&](const Eigen::Vector3d& x) {
    return ((x - analytic::centreOf(g)).squaredNorm() - radius * radius) / (2.0 * radius);
  });
}

void verifyClose(double measured, double expected, double tolerance) {
  QVERIFY2(std::fabs(measured / expected - 1.0) < tolerance,
           qPrintable(QStringLiteral("%1 instead of %2").arg(measured, 0, 'g', 9).arg(expected)));
}

}  // namespace

class TestWallMeasures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBallHasItsVolumeAndArea() {
    for (const double radius : {2.0, 4.3, 8.0}) {
      const SplineField field(quadraticBall(analytic::cube(22), radius), SplineKind::CatmullRom);
      const ZeroSetMeasure ball = measureZeroSet(field);
      verifyClose(ball.volumeMm3, 4.0 / 3.0 * pi * radius * radius * radius, 2e-4);
      verifyClose(ball.areaMm2, 4.0 * pi * radius * radius, 2e-4);
    }
  }

  void spacingAndDirectionCount() {
    const Geometry g = shapes::obliqueGeometry({30, 26, 22}, true);
    const SplineField field(quadraticBall(g, 3.0), SplineKind::CatmullRom);
    const ZeroSetMeasure ball = measureZeroSet(field);
    verifyClose(ball.volumeMm3, 36.0 * pi, 2e-4);
    verifyClose(ball.areaMm2, 36.0 * pi, 2e-4);
  }

  void theBorderCutsAVesselWithoutAddingToTheWall() {
    const Geometry g = analytic::cube(20);
    const Eigen::Vector3d c = analytic::centreOf(g);
    const auto phi = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
      return ((x - c).head<2>().squaredNorm() - 16.0) / 8.0;
    });
    const ZeroSetMeasure tube = measureZeroSet(SplineField(phi, SplineKind::CatmullRom));
    verifyClose(tube.volumeMm3, 16.0 * pi * 19.0, 2e-4);
    verifyClose(tube.areaMm2, 8.0 * pi * 19.0, 2e-4);
  }

  void aTorusConvergesWithItsInterpolant() {
    const Geometry g = analytic::cube(40);
    const auto phi = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
      return analytic::torus(x, analytic::centreOf(g), 11.0, 5.0);
    });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const ZeroSetMeasure torus = measureZeroSet(field);
    verifyClose(torus.volumeMm3, 2.0 * pi * pi * 11.0 * 25.0, 5e-4);
    verifyClose(torus.areaMm2, 4.0 * pi * pi * 11.0 * 5.0, 5e-4);
    const ZeroSetMeasure coarse = measureZeroSet(field, {}, 2);
    verifyClose(coarse.volumeMm3, torus.volumeMm3, 2e-5);
    verifyClose(coarse.areaMm2, torus.areaMm2, 2e-5);
    // Marching cubes is inscribed: it loses what the measure has.
    const double inscribed = enclosedVolumeMm3(marchingCubes(phi));
    QVERIFY(inscribed < torus.volumeMm3 && inscribed > 0.98 * torus.volumeMm3);
  }

  void nothingInsideAndEverythingInside() {
    Volume<float> phi(analytic::cube(9), 1.0F);
    QCOMPARE(measureZeroSet(SplineField(phi, SplineKind::Bspline)).volumeMm3, 0.0);
    for (float& value : phi.voxels) value = -1.0F;
    const ZeroSetMeasure full = measureZeroSet(SplineField(phi, SplineKind::Bspline));
    verifyClose(full.volumeMm3, 512.0, 1e-12);
    QCOMPARE(full.areaMm2, 0.0);
  }

  void noiseAndThreadsAreNoMatter() {
    const SplineField field(shapes::noise({24, 20, 16}, 7), SplineKind::InterpolatingBspline);
    setThreads(1);
    const ZeroSetMeasure one = measureZeroSet(field);
    setThreads(2);
    const ZeroSetMeasure two = measureZeroSet(field);
    QCOMPARE(one.volumeMm3, two.volumeMm3);
    QCOMPARE(one.areaMm2, two.areaMm2);
    QVERIFY(std::isfinite(one.areaMm2));
    verifyClose(one.volumeMm3, 0.5 * 23 * 19 * 15, 0.1);
    const Progress cancelled;
    cancelled.cancel();
    QVERIFY_EXCEPTION_THROWN(measureZeroSet(field, cancelled), Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestWallMeasures)
#include "tst_wall_measures.moc"

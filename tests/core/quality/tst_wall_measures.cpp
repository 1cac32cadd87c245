// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/contour/marching_cubes.h"
#include "core/quality/sizing_check.h"
#include "core/quality/zero_set_measure.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/threads.h"

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

  // The blocks that are measured at once reach the border of a grid of any size.
  void aVesselIsMeasuredToTheBorderOfAnyGrid() {
    for (int n = 17; n < 26; ++n) {
      const Geometry g = analytic::cube(n);
      const Eigen::Vector3d c = analytic::centreOf(g);
      const auto phi = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
        return ((x - c).head<2>().squaredNorm() - 16.0) / 8.0;
      });
      const ZeroSetMeasure tube = measureZeroSet(SplineField(phi, SplineKind::CatmullRom));
      verifyClose(tube.areaMm2, 8.0 * pi * (n - 1), 1e-3);
    }
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

  // phi = x^2 - h^2 has walls at -h and h. Between them it is so flat that the way to the wall, by
  // phi's derivatives, comes out far too long: no piece of wall is moved farther than a fine cell.
  void theMiddleOfAThinPlateMovesNoWallFar() {
    const Geometry g = analytic::cube(8);
    constexpr double half = 0.1, refine = 4.0;
    for (int n = 0; n < 50; ++n) {
      const double middle = 3.0 + 0.02 * n;
      const auto phi = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
        return (x.x() - middle) * (x.x() - middle) - half * half;
      });
      const ZeroSetMeasure plate = measureZeroSet(SplineField(phi, SplineKind::CatmullRom));
      // A straight line finds each wall within a fine cell, and it is moved by one at most.
      QVERIFY(std::fabs(plate.volumeMm3 / 49.0 - 2.0 * half) < 2.0 * 2.0 / refine);
    }
  }

  void nothingInsideAndEverythingInside() {
    Volume<float> phi(analytic::cube(9), 1.0F);
    QCOMPARE(measureZeroSet(SplineField(phi, SplineKind::Bspline)).volumeMm3, 0.0);
    for (float& value : phi.voxels) value = -1.0F;
    const ZeroSetMeasure full = measureZeroSet(SplineField(phi, SplineKind::Bspline));
    verifyClose(full.volumeMm3, 512.0, 1e-12);
    QCOMPARE(full.areaMm2, 0.0);
  }

  void edgesAreComparedWithTheWantedLength() {
    // On a ball the wanted length is the same everywhere.
    const double radius = 6.0;
    const SplineField field(quadraticBall(analytic::cube(22), radius), SplineKind::CatmullRom);
    SizingParams params = SizingParams::printed(0.5);
    params.etaCompensated = true;
    const GuidanceField wanted(field, params);
    const double g = 2.0 * std::sin(0.25) * radius;
    TriMesh mesh = shapes::icosphere(3);
    double sum = 0.0;
    for (Eigen::Vector3d& x : mesh.points) x = analytic::centreOf(field.geometry()) + radius * x;
    for (const auto& t : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        sum += (mesh.points[t[i]] - mesh.points[t[(i + 1) % 3]]).norm();
    const SizingCheck check = checkSizing(mesh, wanted, field.geometry());
    QCOMPARE(check.triangles, mesh.triangles.size());
    verifyClose(check.edgeRatioMean, sum / static_cast<double>(3 * mesh.triangles.size()) / g,
                0.05);
    verifyClose(check.wantedTriangles, surfaceAreaMm2(mesh) / (0.25 * std::sqrt(3.0) * g * g), 0.1);
  }

  void capsDoNotCount() {
    const Geometry g = analytic::cube(16);
    const auto phi = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
      return analytic::tube(x, analytic::centreOf(g), {0, 0, 1}, 4.0);
    });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const GuidanceField wanted(field, {});
    const TriMesh open = marchingCubes(phi, SurfaceBorder::Open);
    const TriMesh capped = marchingCubes(phi, SurfaceBorder::Cap);
    QVERIFY(capped.triangles.size() > open.triangles.size() + 50);
    QCOMPARE(checkSizing(capped, wanted, g).triangles, open.triangles.size());
  }

  void noiseAndThreadsAreNoMatter() {
    const SplineField field(shapes::noise({14, 12, 10}, 7), SplineKind::InterpolatingBspline);
    const auto [one, two] = onOneAndSeveralThreads([&] { return measureZeroSet(field); });
    QCOMPARE(one.volumeMm3, two.volumeMm3);
    QCOMPARE(one.areaMm2, two.areaMm2);
    QVERIFY(std::isfinite(one.areaMm2));
    verifyClose(one.volumeMm3, 0.5 * 13 * 11 * 9, 0.15);
    const Progress cancelled;
    cancelled.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, measureZeroSet(field, cancelled));
  }
};

QTEST_GUILESS_MAIN(TestWallMeasures)
#include "tst_wall_measures.moc"

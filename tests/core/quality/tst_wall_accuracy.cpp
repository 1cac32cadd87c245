// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/quality/wall_accuracy.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/phantom_case.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using analytic::paramsOf;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 6.0;

/// A tube of radius 6 voxels of half a millimetre along z, through the middle of a volume.
PhantomParams tubeParams() {
  PhantomParams params = paramsOf(PhantomKind::Tube, 48, kRadius);
  params.spacingMm = {0.5, 0.5, 0.5};
  return params;
}

/// A mesh of that tube with another radius, mm; longer than the volume.
TriMesh tubeMesh(double radiusMm, int around = 60) {
  TriMesh mesh = shapes::openTube(around, 220, radiusMm);
  const double middle = 0.5 * mesh.points.back()[2];
  const double centre = 0.25 * 47.0;
  return shapes::moved(mesh, {centre, centre, centre - middle});
}

}  // namespace

class TestWallAccuracy : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { setThreads(0); }

  void aWiderTubeIsOutsideByTheDifference() {
    const WallTruth truth(tubeParams());
    for (const double offset : {-0.1, 0.0, 0.07}) {
      const WallAccuracy a = wallAccuracy(tubeMesh(0.5 * kRadius + offset), truth);
      QVERIFY(a.all.vertices > 1000 && a.all.triangles > 2000 && a.leftOut > 0);
      QVERIFY(isNear(a.all.meanMm, offset, 1e-7));
      QVERIFY(a.all.spreadMm < 1e-7);
      QVERIFY(std::fabs(a.all.distance95Mm - std::fabs(offset)) < 1e-7);
      // The mean curvature of a tube of radius r + d is r / (r + d) that of the true one.
      const double error = std::fabs(0.5 * kRadius / (0.5 * kRadius + offset) - 1.0);
      QVERIFY(isNear(a.all.curvatureErrorMedian, error, 0.012));
      QCOMPARE(a.byRadius[3].vertices, a.all.vertices);
      QCOMPARE(a.byRadius[1].vertices, std::size_t{0});
      QVERIFY(std::isnan(a.byRadius[1].meanMm));
      QVERIFY(!a.stenosis);
    }
  }

  /// A triangle with its base around the tube, of angle a, and its apex half-way: the base lies
  /// r a^2 / 8 deeper, so that the facet leans by that over its height, sqrt(3) / 2 r a.
  void normalsOfFacetsAreThoseOfTheirSize() {
    const WallTruth truth(tubeParams());
    for (const int around : {60, 30}) {
      const WallAccuracy a = wallAccuracy(tubeMesh(0.5 * kRadius, around), truth);
      const double expected = 360.0 / around / (4.0 * std::sqrt(3.0));
      QVERIFY(isNear(a.all.normalMeanDeg / expected, 1.0, 0.01));
      QVERIFY(std::fabs(a.all.normal95Deg / expected - 1.0) < 0.01);
    }
  }

  void aTiltedTubeIsOffByTheAngle() {
    const WallTruth truth(tubeParams());
    constexpr double tilt = 3.0;
    TriMesh mesh = tubeMesh(0.5 * kRadius, 120);
    const Vector3d centre = Vector3d::Constant(0.25 * 47.0);
    // Near the middle, where the tilted axis is still on the true one.
    std::erase_if(mesh.triangles,
                  [&](const auto& t) { return std::fabs(mesh.points[t[0]][2] - centre[2]) > 0.2; });
    const Eigen::AngleAxisd turn(tilt * shapes::pi / 180.0, Vector3d::UnitX());
    for (Vector3d& p : mesh.points) p = centre + turn * (p - centre);
    const WallAccuracy a = wallAccuracy(mesh, truth);
    QVERIFY(a.all.triangles > 300);
    // The angle is the tilt times |sin| around the tube: its mean is 2 / pi of that.
    QVERIFY(isNear(a.all.normalMeanDeg, tilt * 2.0 / shapes::pi, 0.1));
    QVERIFY(isNear(a.all.normal95Deg, tilt, 0.5));
    QVERIFY(std::fabs(a.all.meanMm) < 0.005);
  }

  void aShiftSpreadsTheDistances() {
    const WallTruth truth(tubeParams());
    constexpr double shift = 0.1;
    const WallAccuracy a =
        wallAccuracy(shapes::moved(tubeMesh(0.5 * kRadius), {shift, 0, 0}), truth);
    // The distance is nearly shift cos(angle).
    QVERIFY(isNear(a.all.spreadMm, shift / std::sqrt(2.0), 0.001));
    QVERIFY(std::fabs(a.all.meanMm) < 0.002);
    QVERIFY(std::fabs(a.all.distance95Mm - shift) < 0.002);
  }

  void branchingsAndBordersDoNotCount() {
    PhantomParams params = paramsOf(PhantomKind::NeckAneurysm, 64, 4.0);
    const WallTruth truth(params);
    QCOMPARE(truth.branchings().size(), std::size_t{1});
    const Vector3d place = truth.branchings().front().point;
    TriMesh ball = shapes::icosphere(3);
    for (Vector3d& p : ball.points) p = place + 5.0 * p;
    QCOMPARE(wallAccuracy(ball, truth).all.vertices, std::size_t{0});
    QCOMPARE(wallAccuracy(ball, truth).leftOut, ball.points.size());
    const TriMesh far = shapes::moved(shapes::icosphere(2), {200.0, 0.0, 0.0});
    QCOMPARE(wallAccuracy(far, truth).all.vertices, std::size_t{0});
  }

  /// What the file of the sac's ball says is measured on that ball.
  void theSacIsABall() {
    PhantomParams params = paramsOf(PhantomKind::NeckAneurysm, 80, 4.0);
    const Vector3d sac = makePhantom(params).centreLines.back().to;
    TriMesh ball = shapes::icosphere(4);
    for (Vector3d& p : ball.points) p = sac + 8.1 * p;
    std::vector<std::array<std::uint32_t, 3>> beyond;  // away from the neck
    const Vector3d way = (sac - makePhantom(params).centreLines.back().from).normalized();
    for (const auto& t : ball.triangles)
      if ((ball.points[t[0]] - sac).dot(way) > 0.0) beyond.push_back(t);
    ball.triangles = beyond;
    const WallAccuracy a = wallAccuracy(ball, WallTruth(params));
    QVERIFY(a.all.vertices > 300);
    QVERIFY(isNear(a.all.meanMm, 0.1, 1e-6));
    QVERIFY(a.all.normalMeanDeg < 0.5);
    QVERIFY(isBelow(a.all.curvatureErrorMedian, 0.03));
  }

  /// Of a torus around z, whose wall is a saddle on the side of the axis: its mean curvature there
  /// is less than 1 / 4r, which stands in for it.
  void curvaturesOfSaddlesAreMeasuredAgainstTheRadius() {
    constexpr double major = 16.0, minor = 7.0, off = 0.3;
    const WallTruth truth(paramsOf(PhantomKind::Torus, 64, minor));
    const auto meanCurvature = [](double r) { return 0.5 * (1.0 / r - 1.0 / (major - r)); };
    TriMesh mesh = shapes::torus(240, 120, major, minor + off);
    std::erase_if(mesh.triangles, [&](const auto& t) {
      const Vector3d& p = mesh.points[t[0]];
      return std::fabs(p.z()) > 0.5 || p.head<2>().norm() > major;
    });
    const WallAccuracy a = wallAccuracy(shapes::moved(mesh, Vector3d::Constant(31.5)), truth);
    QVERIFY(a.all.vertices > 300);
    QVERIFY(isNear(a.all.meanMm, off, 1e-4));
    QVERIFY(meanCurvature(minor) < 0.2 / minor);
    const double error = (meanCurvature(minor) - meanCurvature(minor + off)) * 4.0 * minor;
    QVERIFY(isNear(a.all.curvatureErrorMedian / error, 1.0, 0.05));
  }

  void aThroatIsAsWideAsItIs() {
    PhantomParams params = paramsOf(PhantomKind::Stenosis, 64, 5.0);
    params.stenosisPercent = 70.0;
    params.axis = {0.3, -0.2, 1.0};
    const WallTruth truth(params);
    QVERIFY(truth.throat().has_value());
    const Throat& throat = *truth.throat();
    QVERIFY(std::fabs(throat.radiusMm - 1.5) < 1e-12);
    // Tubes of the throat's radius and of twice that, along the axis.
    for (const double radius : {1.5, 3.0}) {
      TriMesh mesh = shapes::openTube(90, 400, radius);
      const Eigen::Quaterniond turn =
          Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), throat.axis);
      const double middle = 0.5 * mesh.points.back()[2];
      for (Vector3d& p : mesh.points) p = throat.centre + turn * (p - Vector3d(0.0, 0.0, middle));
      const auto found = leastDiameter(mesh, throat, 1.0);
      QVERIFY(found.has_value());
      QVERIFY(isNear(*found / (2.0 * radius), 1.0, 0.002));
      const auto measured = wallAccuracy(mesh, truth).stenosis;
      QVERIFY(measured && std::fabs(measured->trueMm - 3.0) < 1e-12);
      QCOMPARE(measured->foundMm, *found);
      // Cut through at the throat, nothing is left there.
      TriMesh cut = mesh;
      std::erase_if(cut.triangles, [&](const auto& t) {
        return std::fabs((cut.points[t[0]] - throat.centre).dot(throat.axis)) < 1.0;
      });
      QCOMPARE(leastDiameter(cut, throat, 1.0).value_or(-1.0), 0.0);
    }
    QVERIFY(!leastDiameter(shapes::moved(shapes::icosphere(2), {900, 0, 0}), throat, 1.0));
  }

  void doesNotDependOnTheThreads() {
    const PhantomParams params = paramsOf(PhantomKind::VesselTree, 64, 4.0);
    const WallTruth truth(params);
    TriMesh ball = shapes::icosphere(4);
    for (Vector3d& p : ball.points) p = Vector3d::Constant(31.5) + 12.0 * p;
    const auto [one, two] = onOneAndSeveralThreads([&] { return wallAccuracy(ball, truth); });
    QVERIFY(one.all.vertices > 0);
    QCOMPARE(one.all.meanMm, two.all.meanMm);
    QCOMPARE(one.all.normalMeanDeg, two.all.normalMeanDeg);
    QCOMPARE(one.all.curvatureErrorMedian, two.all.curvatureErrorMedian);
  }
};

QTEST_GUILESS_MAIN(TestWallAccuracy)
#include "tst_wall_accuracy.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "core/phantom/shape.h"
#include "core/quality/mesh_quality.h"
#include "core/surface/zero_set_mesh.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_bars.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

// The accuracy that the bars are set for.
SizingParams literal(double rho = 0.4) { return SizingParams::printed(rho); }

ZeroSetMesh meshed(const Volume<float>& phi, const SizingParams& sizing = literal(),
                   SurfaceBorder border = SurfaceBorder::Cap,
                   SurfaceMethod method = SurfaceMethod::AdvancingFront) {
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  return meshZeroSet(field, sizing, method, border);
}

Volume<float> kissing() {
  PhantomParams params;
  params.kind = PhantomKind::Kissing;
  params.size = {48, 48, 48};
  params.radius = 3.0;
  const Shape shape = analyticShape(params);
  return analytic::sampled(phantomGeometry(params),
                           [&](const Vector3d& p) { return shape.signedDistance(p); });
}

Volume<float> capsuleTree(const Geometry& g) {
  PhantomParams params;
  params.kind = PhantomKind::CapsuleTree;
  params.size = {56, 56, 56};
  params.radius = 2.6;
  const Shape shape = analyticShape(params);
  const Vector3d shift = phantomGeometry(params).toPhysical({27.5, 27.5, 27.5});
  const Vector3d centre = analytic::centreOf(g);
  return analytic::sampled(
      g, [&](const Vector3d& p) { return shape.signedDistance(p - centre + shift); });
}

Volume<float> shapeNamed(const QString& name) {
  const Geometry cube = analytic::cube(32);
  const Vector3d c{15.4, 15.2, 15.7};
  if (name == "sphere")
    return analytic::sampled(cube, [&](const Vector3d& p) { return analytic::ball(p, c, 9.3); });
  if (name == "torus")
    return analytic::sampled(cube,
                             [&](const Vector3d& p) { return analytic::torus(p, c, 8.5, 3.1); });
  if (name == "double torus") {
    Geometry g = cube;
    g.size = {48, 30, 16};
    return analytic::sampled(g, [](const Vector3d& p) {
      const double a = analytic::torus(p, {15.2, 14.6, 7.4}, 8.5, 3.1);
      const double b = analytic::torus(p, {31.7, 14.6, 7.4}, 8.5, 3.1);
      const double h = std::max(4.0 - std::abs(a - b), 0.0) / 4.0;
      return std::min(a, b) - h * h * h * 4.0 / 6.0;
    });
  }
  if (name == "thin sheet")
    return analytic::sampled(cube, [&](const Vector3d& p) {
      const Vector3d d = (p - c).cwiseAbs() - Vector3d(8.0, 8.0, 0.1);
      return d.cwiseMax(0.0).norm() + std::min(d.maxCoeff(), 0.0) - 0.9;
    });
  if (name == "kissing tubes") return kissing();
  return capsuleTree(analytic::cube(56));
}

struct Expectation {
  const char* name;
  int components, euler;
};

}  // namespace

class TestZeroSetMesh : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void meetsTheBars_data() {
    QTest::addColumn<int>("components");
    QTest::addColumn<int>("euler");
    const Expectation all[] = {{"sphere", 1, 2},        {"torus", 1, 0},
                               {"double torus", 1, -2}, {"thin sheet", 1, 2},
                               {"kissing tubes", 2, 4}, {"capsule tree", 1, 0}};
    for (const Expectation& e : all) QTest::newRow(e.name) << e.components << e.euler;
  }
  void meetsTheBars() {
    QFETCH(int, components);
    QFETCH(int, euler);
    const Volume<float> phi = shapeNamed(QTest::currentDataTag());
    const ZeroSetMesh surface = meshed(phi);
    const MeshQuality q = measureQuality(surface.mesh);
    verifySoundShape(q);
    QVERIFY(q.closed);
    QCOMPARE(q.components, components);
    QCOMPARE(q.euler, euler);
    QCOMPARE(surface.components.size(), static_cast<std::size_t>(components));
    QVERIFY2(surface.fromFrontPercent >= 95.0,
             qPrintable(QString::number(surface.fromFrontPercent)));
    QVERIFY(std::abs(surface.estimatedTriangles / static_cast<double>(q.triangles) - 1.0) < 0.15);
  }

  void verifiesCleanComponents() {
    for (const char* name : {"sphere", "torus", "capsule tree"}) {
      const ZeroSetMesh surface = meshed(shapeNamed(name));
      for (const SurfaceComponent& c : surface.components)
        QVERIFY2(c.verified, qPrintable(QString("%1: %2").arg(name, c.why.c_str())));
      QVERIFY(surface.dropped.empty());
    }
  }

  void keepsVerticesOnTheZeroSet() {
    const Volume<float> phi = shapeNamed("torus");
    const ZeroSetMesh surface = meshed(phi);
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const MeshQuality q = measureQuality(surface.mesh, &field);
    QVERIFY(q.vertexDeviation->maxMm < 1e-4);
  }

  // The largest curvature of a torus is that of its tube, everywhere.
  void edgesSpanTheAngleRho() {
    const double chord = 0.8 * 2.0 * std::sin(0.2) * 3.1;
    const MeshQuality q = measureQuality(meshed(shapeNamed("torus"), literal(0.4)).mesh);
    QVERIFY2(std::abs(q.edgeMeanMm / chord - 1.0) < 0.05,
             qPrintable(QString::number(q.edgeMeanMm)));
  }

  void halvesTheEdgesWithRho() {
    const Volume<float> phi = shapeNamed("torus");
    const MeshQuality coarse = measureQuality(meshed(phi, literal(0.4)).mesh);
    const MeshQuality fine = measureQuality(meshed(phi, literal(0.2)).mesh);
    QVERIFY(std::abs(fine.edgeMeanMm / coarse.edgeMeanMm - 0.5) < 0.02);
  }

  void isTheSameForAnyNumberOfThreads() {
    const Volume<float> phi = shapeNamed("kissing tubes");
    const auto [one, two] = onOneAndSeveralThreads([&] { return meshed(phi); });
    QVERIFY(one.mesh.points == two.mesh.points);
    QVERIFY(one.mesh.triangles == two.mesh.triangles);
  }

  void respectsTheGrid() {
    Geometry g = analytic::oblique(60, 60, 40);
    const Vector3d c = analytic::centreOf(g);
    const Volume<float> phi =
        analytic::sampled(g, [&](const Vector3d& p) { return analytic::torus(p, c, 6.0, 2.4); });
    const ZeroSetMesh surface = meshed(phi);
    const MeshQuality q = measureQuality(surface.mesh);
    verifySoundShape(q);
    QCOMPARE(q.euler, 0);
    const double volume = 2.0 * M_PI * M_PI * 6.0 * 2.4 * 2.4;
    QVERIFY(q.volumeMm3 > 0.97 * volume && q.volumeMm3 < volume);
    // A mirrored grid turns no face inside out.
    g.direction.col(0) *= -1.0;
    const Vector3d d = analytic::centreOf(g);
    const Volume<float> mirrored =
        analytic::sampled(g, [&](const Vector3d& p) { return analytic::torus(p, d, 6.0, 2.4); });
    QVERIFY(measureQuality(meshed(mirrored).mesh).volumeMm3 > 0.97 * volume);
  }

  void endsAtTheBorder_data() {
    QTest::addColumn<bool>("cap");
    QTest::newRow("caps") << true;
    QTest::newRow("open") << false;
  }
  void endsAtTheBorder() {
    QFETCH(bool, cap);
    const Vector3d axis = Vector3d(0.3, 0.1, 1.0).normalized();
    const Volume<float> phi = analytic::sampled(analytic::cube(24), [&](const Vector3d& p) {
      return analytic::tube(p, {11.5, 11.5, 11.5}, axis, 4.3);
    });
    const ZeroSetMesh surface =
        meshed(phi, literal(), cap ? SurfaceBorder::Cap : SurfaceBorder::Open);
    const MeshQuality q = measureQuality(surface.mesh);
    verifySoundShape(q);
    QCOMPARE(q.components, 1);
    QCOMPARE(q.closed, cap);
    QCOMPARE(q.boundaryLoops, cap ? 0U : 2U);
    QCOMPARE(q.euler, cap ? 2 : 0);
    for (const Vector3d& p : surface.mesh.points) QVERIFY(p.z() > -1e-9 && p.z() < 23.0 + 1e-9);
    std::size_t flat = 0;
    for (const auto& t : surface.mesh.triangles) {
      double high = 0.0;
      for (const std::uint32_t v : t) high = std::max(high, std::abs(surface.mesh.points[v].z()));
      if (high < 1e-9) ++flat;
    }
    QCOMPARE(flat > 20, cap);
  }

  // A ball that leaves the volume through all six faces: its caps leave a part of every face.
  void closesAllSixFaces() {
    const Volume<float> phi = analytic::sampled(analytic::cube(20), [](const Vector3d& p) {
      return analytic::ball(p, {9.5, 9.4, 9.6}, 10.6);
    });
    const MeshQuality q = measureQuality(meshed(phi, literal(0.15)).mesh);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.selfIntersections, 0U);
    QVERIFY(q.minAngleMin >= 30.0 && q.maxAngleMax <= 110.0);
    QCOMPARE(q.euler, 2);
  }

  // Three caps meet in each corner of a volume whose sides differ.
  void closesAroundEachCornerOfTheVolume() {
    Geometry g = analytic::cube(16);
    g.size = {17, 15, 13};
    g.spacing = {0.9, 1.0, 1.2};
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d at =
          g.toPhysical({16.0 * (corner & 1), 14.0 * (corner >> 1 & 1), 12.0 * (corner >> 2)});
      const Vector3d centre = at + 0.03 * (analytic::centreOf(g) - at);
      const double radius = 6.0;
      const ZeroSetMesh surface = meshed(analytic::sampled(
          g, [&](const Vector3d& p) { return analytic::ball(p, centre, radius); }));
      const MeshQuality q = measureQuality(surface.mesh);
      QVERIFY(q.closed && q.oriented);
      QCOMPARE(q.euler, 2);
      QCOMPARE(q.selfIntersections, 0U);
      QVERIFY(surface.fromFrontPercent >= 95.0);
      QVERIFY(std::any_of(surface.mesh.points.begin(), surface.mesh.points.end(),
                          [&](const Vector3d& p) { return (p - at).norm() < 1e-9; }));
      // What the three planes cut off of the ball.
      double expected = 0.0;
      constexpr int fine = 60;
      const Vector3d inwards = (analytic::centreOf(g) - at).cwiseSign();
      for (int n = 0; n < fine * fine; ++n) {
        const Vector3d p = at + inwards.cwiseProduct(Vector3d((n % fine + 0.5) * 7.0 / fine,
                                                              (n / fine + 0.5) * 7.0 / fine, 0.0));
        const double rest = radius * radius - (p - centre).head<2>().squaredNorm();
        if (rest > 0.0)
          expected +=
              std::max(0.0, std::sqrt(rest) + std::fabs(centre[2] - at[2])) * 49.0 / (fine * fine);
      }
      QVERIFY(isNear(q.volumeMm3 / expected, 0.97, 0.03));
    }
  }

  // The whole volume inside but for a hole: caps that meet along the volume's edges.
  void closesAlongTheEdgesOfTheVolume() {
    const Volume<float> phi = analytic::sampled(analytic::cube(16), [](const Vector3d& p) {
      return analytic::tube(p, {2.0, 3.0, 7.5}, Vector3d::UnitZ(), 8.2);
    });
    const ZeroSetMesh surface = meshed(phi);
    const MeshQuality q = measureQuality(surface.mesh);
    QVERIFY(q.closed);
    QVERIFY(q.oriented);
    QCOMPARE(q.nonManifoldEdges, 0U);
    QCOMPARE(q.euler, 2);
  }

  void takesAwkwardValues_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("exact zeros") << 0;
    QTest::newRow("integers") << 1;
    QTest::newRow("mask") << 2;
    QTest::newRow("plateau") << 3;
    QTest::newRow("specks") << 4;
    QTest::newRow("noise") << 5;
  }
  void takesAwkwardValues() {
    QFETCH(int, kind);
    const Geometry g = analytic::cube(20);
    const Vector3d c{9.5, 9.5, 9.5};
    Volume<float> phi =
        analytic::sampled(g, [&](const Vector3d& p) { return analytic::ball(p, c, 6.0); });
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      float& f = phi.voxels[i];
      if (kind == 0 && std::abs(f) < 0.3F) f = 0.0F;
      if (kind == 1) f = std::round(f);
      if (kind == 2) f = f < 0.0F ? -0.5F : 0.5F;
      if (kind == 3) f = std::clamp(f, -0.4F, 0.4F);
      if (kind == 4) f = randomUniform(3, i) < 0.004 ? -0.5F : 0.5F;
      if (kind == 5) f += 0.25F * static_cast<float>(randomNormal(5, i));
    }
    SizingParams coarse = literal();
    coarse.edgeMinMm = 0.2;
    const ZeroSetMesh surface = meshed(phi, coarse);
    const MeshQuality q = measureQuality(surface.mesh);
    QVERIFY(q.triangles > 0);
    QVERIFY(q.closed);
    QVERIFY(q.oriented);
    QCOMPARE(q.nonManifoldEdges, 0U);
    QCOMPARE(q.nonManifoldVertices, 0U);
    QCOMPARE(q.degenerateTriangles, 0U);
  }

  // Tubes so close that the interpolant's curves in the border plane all but touch, and turn about
  // the gap in another way than marching cubes'.
  void keepsCloseRimsApart() {
    const Volume<float> phi = analytic::sampled(analytic::cube(48), [](const Vector3d& p) {
      const double slant = 0.1 * (p.z() - 24.0);
      return std::min(std::hypot(p.x() - 20.0, p.y() - 24.0) - 3.0,
                      std::hypot(p.x() - 26.6, p.y() - 24.0 + slant) - 3.0);
    });
    const ZeroSetMesh surface = meshed(phi);
    const MeshQuality q = measureQuality(surface.mesh);
    verifySoundShape(q);
    QVERIFY(q.closed);
    QVERIFY2(surface.fromFrontPercent >= 95.0,
             qPrintable(QString::number(surface.fromFrontPercent)));
  }

  // Plateaus of exact zeros, about which an interpolant rings: sheets that touch in many places.
  void meetsNowhereOnPlateaus() {
    const Vector3d axis = Vector3d(0.35, 0.5, 1.0).normalized();
    const Volume<float> phi = analytic::sampled(analytic::cube(26), [&](const Vector3d& p) {
      return std::round(analytic::tube(p, {12.1, 12.4, 12.7}, axis, 3.4));
    });
    const ZeroSetMesh surface = meshed(phi);
    const MeshQuality q = measureQuality(surface.mesh);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.nonManifoldEdges, 0U);
    QCOMPARE(q.nonManifoldVertices, 0U);
    QCOMPARE(q.selfIntersections, 0U);
  }

  // A ball between the voxels: no voxel lies in it, but the spline dips below 0.
  void findsWhatNoVoxelLiesIn() {
    const Vector3d c{9.5, 9.5, 9.5};
    Volume<float> phi = analytic::sampled(analytic::cube(20), [&](const Vector3d& p) {
      return 0.35 * ((p - c).squaredNorm() - 0.6 * 0.6);
    });
    const ZeroSetMesh surface = meshed(phi);
    const MeshQuality q = measureQuality(surface.mesh);
    QVERIFY(q.closed);
    QCOMPARE(q.components, 1);
    QCOMPARE(q.euler, 2);
    QVERIFY(std::abs(q.volumeMm3 / (4.0 / 3.0 * M_PI * 0.216) - 1.0) < 0.05);
  }

  void meshesNothing() {
    const Volume<float> phi(analytic::cube(8), 1.0F);
    const ZeroSetMesh surface = meshed(phi);
    QVERIFY(surface.mesh.triangles.empty());
    QVERIFY(surface.components.empty());
  }

  void remeshesToo() {
    const Volume<float> phi = shapeNamed("torus");
    const ZeroSetMesh surface = meshed(phi, literal(), SurfaceBorder::Cap, SurfaceMethod::Remesh);
    verifySoundShape(measureQuality(surface.mesh));
    QCOMPARE(surface.fromFrontPercent, 0.0);
    QCOMPARE(measureQuality(surface.mesh).euler, 0);
    QVERIFY_THROWS_EXCEPTION(
        InputError, meshed(phi, literal(), SurfaceBorder::Cap, SurfaceMethod::MarchingCubes));
  }

  void canBeCancelled() {
    const SplineField field(shapeNamed("torus"), SplineKind::InterpolatingBspline);
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, meshZeroSet(field, literal(), SurfaceMethod::AdvancingFront,
                                                    SurfaceBorder::Cap, progress));
  }
};

QTEST_GUILESS_MAIN(TestZeroSetMesh)
#include "tst_zero_set_mesh.moc"

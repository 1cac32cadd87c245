// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <functional>

#include "core/base/error.h"
#include "core/pipeline/surface_step.h"
#include "core/quality/mesh_quality.h"
#include "core/surface/zero_set_mesh.h"
#include "tests/core/analytic.h"

using namespace angiomesh;

namespace {

/// A large ball and a small one beside it.
Volume<float> twoBalls() {
  return analytic::sampled(analytic::cube(30), [](const Eigen::Vector3d& x) {
    return std::min(analytic::ball(x, {11.0, 14.5, 14.5}, 7.0),
                    analytic::ball(x, {23.5, 14.5, 14.5}, 2.5));
  });
}

SurfaceParams plain() {
  SurfaceParams params;
  params.sizing.edgesAround = 0;
  return params;
}

double triangles(const std::function<void(SurfaceParams&)>& change) {
  SurfaceParams params = plain();
  change(params);
  const SplineField field(twoBalls(), params.spline);
  return estimateTriangles(field, params);
}

}  // namespace

class TestSurfaceStep : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachParameterActsAsItsHelpSays() {
    const double usual = triangles([](SurfaceParams&) {});
    const auto more = [&](auto change) { return triangles(change) > 1.1 * usual; };
    const auto fewer = [&](auto change) { return triangles(change) < 0.9 * usual; };
    QVERIFY(more([](SurfaceParams& p) { p.sizing.rho = 0.2; }));
    QVERIFY(fewer([](SurfaceParams& p) { p.sizing.rho = 0.8; }));
    QVERIFY(more([](SurfaceParams& p) { p.sizing.etaInverse = 0.97; }));
    QVERIFY(more([](SurfaceParams& p) { p.sizing.etaCompensated = false; }));
    QVERIFY(fewer([](SurfaceParams& p) { p.sizing.curvatureRelax = 3.0; }));
    QVERIFY(more([](SurfaceParams& p) { p.sizing.edgesAround = 48; }));
    QVERIFY(more([](SurfaceParams& p) { p.sizing.edgeMaxMm = 0.8; }));
    QVERIFY(fewer([](SurfaceParams& p) { p.sizing.edgeMinMm = 5.0; }));
  }

  void moreTrianglesThanTheMemoryHoldsAreRefused() {
    checkMemoryFor(1e5);
    try {
      checkMemoryFor(1e12);
      QFAIL("a million million triangles");
    } catch (const InputError& error) {
      QVERIFY2(QString(error.what()).contains("1000000 million triangles"), error.what());
    }
  }

  void theFrontAndTheRemesherFollowTheSize_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("front") << static_cast<int>(SurfaceMethod::AdvancingFront);
    QTest::newRow("remesh") << static_cast<int>(SurfaceMethod::Remesh);
  }

  void theFrontAndTheRemesherFollowTheSize() {
    QFETCH(int, method);
    SurfaceParams params;
    params.method = static_cast<SurfaceMethod>(method);
    const Volume<float> phi = twoBalls();
    const SplineField field(phi, params.spline);
    const MadeSurface made = makeSurface(phi, field, params);
    const MeshQuality quality = measureQuality(made.mesh, &field);
    QVERIFY(quality.closed && quality.oriented);
    QCOMPARE(quality.components, 2);
    QCOMPARE(quality.euler, 4);
    QVERIFY(quality.minAngleMin > 25.0);
    QCOMPARE(made.origin.method, params.method);
    QCOMPARE(made.origin.components.size(), std::size_t{2});
    QCOMPARE(made.origin.warnings().size(), made.origin.unverified());
    QCOMPARE(made.origin.components[0].triangles + made.origin.components[1].triangles,
             made.mesh.triangles.size());
    QCOMPARE(made.origin.fromFrontPercent.has_value(),
             params.method == SurfaceMethod::AdvancingFront);
    if (made.origin.fromFrontPercent) QVERIFY(*made.origin.fromFrontPercent >= 95.0);
    const double ratio =
        static_cast<double>(made.mesh.triangles.size()) / *made.origin.estimatedTriangles;
    QVERIFY2(ratio > 0.85 && ratio < 1.15, qPrintable(QString::number(ratio)));
  }

  void theComponentsAreThoseOfTheMesh() {
    const Volume<float> phi = analytic::sampled(analytic::cube(24), [](const Eigen::Vector3d& x) {
      return std::min(analytic::tube(x, {7.0, 11.5, 11.5}, {0, 0, 1}, 3.0),
                      analytic::ball(x, {17.5, 11.5, 11.5}, 3.5));
    });
    for (const SurfaceBorder border : {SurfaceBorder::Open, SurfaceBorder::Cap}) {
      SurfaceParams params;
      params.border = border;
      const SplineField field(phi, params.spline);
      const MadeSurface made = makeSurface(phi, field, params);
      const MeshQuality quality = measureQuality(made.mesh);
      int euler = 0, loops = 0;
      for (const SurfaceComponent& part : made.origin.components) {
        euler += part.euler;
        loops += part.boundaryLoops;
      }
      QCOMPARE(made.origin.components.size(), std::size_t{2});
      QCOMPARE(euler, quality.euler);
      QCOMPARE(loops, static_cast<int>(quality.boundaryLoops));
      QCOMPARE(loops, border == SurfaceBorder::Open ? 2 : 0);
    }
  }

  void smallComponentsAreLeftOutAndNamed() {
    const Volume<float> phi = twoBalls();
    for (const SurfaceMethod method :
         {SurfaceMethod::AdvancingFront, SurfaceMethod::MarchingCubes}) {
      SurfaceParams params;
      params.method = method;
      params.minComponentMm3 = 200.0;
      const SplineField field(phi, params.spline);
      const MadeSurface made = makeSurface(phi, field, params);
      QCOMPARE(measureQuality(made.mesh).components, 1);
      QCOMPARE(made.origin.components.size(),
               std::size_t{method == SurfaceMethod::AdvancingFront ? 1U : 0U});
      QCOMPARE(made.origin.dropped.size(), std::size_t{1});
      QCOMPARE(made.origin.warnings().size(), made.origin.unverified() + 1);
      params.minComponentMm3 = 1e6;
      QVERIFY(makeSurface(phi, field, params).mesh.triangles.empty());
    }
  }

  void whatIsNotVerifiedIsSaidButNotWithoutEnd() {
    SurfaceOrigin origin;
    SurfaceComponent part;
    part.why = "a reason";
    origin.components.assign(500, part);
    part.verified = true;
    origin.components.push_back(part);
    origin.dropped.assign(300, "a speck");
    QCOMPARE(origin.unverified(), std::size_t{500});
    const std::vector<std::string> warnings = origin.warnings();
    QVERIFY(warnings.size() < 60);
    QVERIFY(warnings.front().find("a reason") != std::string::npos);
    QVERIFY(warnings.back().find("280 more") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(TestSurfaceStep)
#include "tst_surface_step.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/base/random.h"
#include "core/pipeline/expected_surface.h"
#include "core/quality/mesh_quality.h"
#include "core/surface/zero_set_mesh.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/refusal.h"

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
  params.sizing = SizingParams::printed();
  params.sizing.etaCompensated = true;
  return params;
}

double triangles(const std::function<void(SurfaceParams&)>& change) {
  SurfaceParams params = plain();
  change(params);
  const SplineField field(twoBalls(), params.spline);
  return expectSurface(twoBalls(), field, params).triangles;
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

  void moreTrianglesThanMemoryAndTimeHoldAreRefused() {
    SurfaceLimits limits;
    limits.bytes = 1e9;
    limits.seconds = 1e9;
    ExpectedSurface expected;
    expected.smoothTriangles = 1e5;
    expected.triangles = 1e5;
    const SurfaceParams usual;
    checkExpected(expected, usual, limits);
    expected.triangles = 1e7;
    const QString text =
        QString::fromStdString(messageOf([&] { checkExpected(expected, usual, limits); }));
    QVERIFY2(text.contains("about 10 million triangles") && text.contains("100 times") &&
                 text.contains("surface.edgeMinMm") && text.contains("maxTriangles"),
             qPrintable(text));
    limits = {1e15, 60.0};
    QVERIFY(refusal(expected, usual, limits)->find("minutes") != std::string::npos);
    QVERIFY(!refusal(expected, usual, {1e15, 1e9}));
    QVERIFY(!refusal(expected, usual, {0.0, 1e9}));  // a machine whose memory is not known
    SurfaceParams set;
    set.maxTriangles = 0;
    QVERIFY(!refusal(expected, set, limits));
    set.maxTriangles = 9999999;
    QVERIFY(refusal(expected, set, {1e15, 1e9}));
    set.maxTriangles = 10000000;
    QVERIFY(!refusal(expected, set, limits));
  }

  void refusalsSayHowMuchItWouldTake() {
    ExpectedSurface expected;
    expected.triangles = 1.0;
    const double bytes = expected.bytes(), seconds = expected.seconds();
    const double gigabyte = 1024.0 * 1024.0 * 1024.0;
    const SurfaceParams usual;
    expected.triangles = 40.0 * gigabyte / bytes;
    const QString memory =
        QString::fromStdString(*refusal(expected, usual, {3.0 * gigabyte, 1e12}));
    QVERIFY2(memory.contains("40 GB") && memory.contains("has 3 GB"), qPrintable(memory));
    for (const auto& [wanted, said] : {std::pair{30.0, "about 1 minutes"},
                                       {600.0, "about 10 minutes"},
                                       {9000.0, "about 2.5 h"}}) {
      expected.triangles = wanted / seconds;
      const QString time = QString::fromStdString(*refusal(expected, usual, {1e18, 20.0}));
      QVERIFY2(time.contains(said), qPrintable(time));
    }
  }

  void warnsOfRoughWallsAndOfLongWork() {
    ExpectedSurface expected;
    expected.triangles = 1e6;
    expected.smoothTriangles = 5e5;
    QVERIFY(warningsOf(expected).empty());
    expected.smoothTriangles = 5e4;
    expected.smoothEdgeMm = 0.25;
    expected.parts = 7;
    const std::string rough = warningsOf(expected).at(0);
    for (const char* word : {"20 times", "surface.edgeMinMm, such as 0.25", "7 parts",
                             "segmentation.keep", "segmentation.minVolumeMm3"})
      QVERIFY2(rough.find(word) != std::string::npos, rough.c_str());
    expected = {1e4, 1e2};
    QVERIFY(warningsOf(expected).empty());
    expected = {1e6, 5e5};
    expected.specks = 900;
    expected.speckTriangles = 4e5;
    QVERIFY(warningsOf(expected).at(0).find("900 specks") != std::string::npos);
    expected = {1e9, 1e9};
    QVERIFY(warningsOf(expected).at(0).find("hours") != std::string::npos);
  }

  /// Closed forms: edges of 2 sin(rho / 2) r, but for the pieces between junctions.
  void smoothVesselsJustifyTheirTriangles() {
    const double perArea = 4.0 / std::sqrt(3.0) / std::pow(2.0 * std::sin(0.2), 2);
    const auto expectedOf = [](const Geometry& g, const auto& f) {
      const Volume<float> phi = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
        return std::clamp(f(x), -5.0 * g.voxelMm(), 5.0 * g.voxelMm());
      });
      const SurfaceParams params = plain();
      return expectSurface(phi, SplineField(phi, params.spline), params);
    };
    const Geometry g = analytic::cube(44);
    const Eigen::Vector3d c = analytic::centreOf(g) + Eigen::Vector3d(0.3, 0.1, -0.2);
    const auto near = [](double value, double truth, double share) {
      return std::fabs(value / truth - 1.0) < share;
    };
    for (const double r : {2.0, 4.5}) {
      const ExpectedSurface tube = expectedOf(g, [&](const auto& x) {
        return analytic::tube(x, c, {0, 0, 1}, r);
      });
      QVERIFY(near(tube.smoothTriangles, perArea * 2.0 * M_PI * 43.0 / r, 0.1));
      QVERIFY(tube.roughness() > 0.9 && tube.roughness() < 1.3);
      const ExpectedSurface ball =
          expectedOf(g, [&](const auto& x) { return analytic::ball(x, c, r + 2.0); });
      // The centre lines take it for a short vessel.
      QVERIFY(near(ball.smoothTriangles, perArea * 6.0 * M_PI, 0.4));
      QVERIFY(near(ball.triangles, perArea * 4.0 * M_PI, 0.1));
      const ExpectedSurface ring =
          expectedOf(g, [&](const auto& x) { return analytic::torus(x, c, 13.5, r); });
      QVERIFY(near(ring.smoothTriangles, perArea * 4.0 * M_PI * M_PI * 13.5 / r, 0.25));
      QVERIFY(ring.roughness() > 0.75 && ring.roughness() < 1.5);
    }
    // Caps count, where there are any: here they have a tenth of the wall's area.
    SurfaceParams open = plain();
    open.border = SurfaceBorder::Open;
    const Volume<float> wide = analytic::sampled(g, [&](const Eigen::Vector3d& x) {
      return analytic::tube(x, c, {0, 0, 1}, 4.5);
    });
    const SplineField field(wide, open.spline);
    QVERIFY(near(
        expectSurface(wide, field, plain()).triangles / expectSurface(wide, field, open).triangles,
        1.085, 0.035));
    // A wall with ripples of a voxel, as noise makes them.
    const ExpectedSurface rough = expectedOf(g, [&](const Eigen::Vector3d& x) {
      return analytic::tube(x, c, {0, 0, 1}, 4.5) +
             0.3 * std::sin(2.9 * x[0]) * std::sin(2.7 * x[1]) * std::sin(2.8 * x[2]);
    });
    QVERIFY(isAbove(rough.roughness(), 5.0));
    QVERIFY(near(rough.smoothTriangles, perArea * 2.0 * M_PI * 43.0 / 4.5, 0.2));
  }

  void partsAndSpecksAreCounted() {
    const Volume<float> phi = analytic::clamped(analytic::cube(36), [](const Eigen::Vector3d& x) {
      return std::min({analytic::ball(x, {10.2, 10.1, 10.3}, 6.0),
                       analytic::ball(x, {26.1, 25.8, 26.2}, 4.0),
                       analytic::ball(x, {8.0, 28.2, 28.1}, 1.2)});
    });
    const SurfaceParams params = plain();
    const SplineField field(phi, params.spline);
    const ExpectedSurface all = expectSurface(phi, field, params);
    QCOMPARE(all.parts, 3);
    // Less than a hundredth of the largest part; balls have as many triangles, whatever their size.
    QCOMPARE(all.specks, 1);
    QVERIFY(isNear(all.speckTriangles / all.smoothTriangles, 1.0 / 3.0, 0.2));
    std::vector<SegmentComponent> components = allComponents(phi);
    QCOMPARE(components.size(), std::size_t{3});
    components[1].kept = false;
    const GuidanceField size(field, params.sizing);
    const ExpectedSurface kept = expectSurface(field, size, params, components);
    QCOMPARE(kept.parts, 2);
    QVERIFY(kept.smoothTriangles < 0.8 * all.smoothTriangles);
  }

  void aBlobOfNoiseIsRoughAtTheDefaultSize() {
    Volume<float> phi(analytic::cube(28));
    for (std::size_t n = 0; n < phi.voxels.size(); ++n) {
      const Index3 p = phi.geometry.indexOf(n);
      const bool in = std::all_of(p.begin(), p.end(), [](int i) { return i > 1 && i < 26; });
      phi.voxels[n] = in && randomUniform(5, n) < 0.5 ? -0.5F : 0.5F;
    }
    const SurfaceParams params;
    const ExpectedSurface blob = expectSurface(phi, SplineField(phi, params.spline), params);
    QVERIFY(blob.triangles > 2e5);
    QVERIFY2(!warningsOf(blob).empty(), qPrintable(QString::number(blob.roughness())));
    QVERIFY(warningsOf(blob)[0].find("the wall is rough") != std::string::npos);
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

  /// Cells of marching cubes count in voxels, whatever these measure, with cuts and without.
  void cellsAreInVoxels() {
    for (const bool cut : {false, true}) {
      std::vector<std::size_t> triangles;
      for (const double voxelMm : {1.0, 0.4, 2.0}) {
        Geometry g = analytic::cube(24);
        g.size = {30, 24, 24};
        g.spacing.setConstant(voxelMm);
        const Volume<float> phi = analytic::clamped(g, [&](const Eigen::Vector3d& x) {
          return voxelMm *
                 analytic::tube(x / voxelMm, {0.0, 11.6, 11.3}, Eigen::Vector3d::UnitX(), 5.0);
        });
        SurfaceParams params;
        params.method = SurfaceMethod::MarchingCubes;
        params.cellVoxels = 1.7;
        const SplineField field(phi, params.spline);
        CutAway away;
        if (cut)
          away = cutAway(field, phi,
                         {{Eigen::Vector3d(20.2, 11.6, 11.3) * voxelMm, Eigen::Vector3d::UnitX()}});
        const MadeSurface made = makeSurface(phi, field, params, {}, away);
        triangles.push_back(made.mesh.triangles.size());
      }
      QVERIFY(triangles[0] > 400 && triangles[0] < 4000);
      QVERIFY(isNear(1.0 * triangles[1] / triangles[0], 1.0, 0.05));
      QVERIFY(isNear(1.0 * triangles[2] / triangles[0], 1.0, 0.05));
    }
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

  /// Where a hole is and where vessels touch, each in its own words; of a loop, nothing.
  void smallHandlesAreSaidInTheirWords() {
    Handle hole, thin, loop;
    hole.kind = HandleKind::Hole;
    hole.lengthMm = 2.5;
    hole.centreLps = {1.0, 2.0, 3.0};
    hole.placeLps = {-7.0, -7.0, -7.0};
    thin.kind = HandleKind::Thin;
    thin.lengthMm = 40.0;
    thin.placeLps = {4.0, 5.0, 6.0};
    thin.centreLps = {-9.0, -9.0, -9.0};
    SurfaceOrigin origin;
    origin.handles = {hole, thin, loop};
    const std::vector<std::string> warnings = origin.warnings();
    QCOMPARE(warnings.size(), std::size_t{2});
    const auto has = [](const std::string& text, const std::string& words) {
      return text.find(words) != std::string::npos;
    };
    QVERIFY(has(warnings[0], "a hole of 2.5 mm") && has(warnings[0], placeText(hole.centreLps)));
    QVERIFY(has(warnings[1], "a loop of 40 mm") && has(warnings[1], placeText(thin.placeLps)));
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
    std::vector<std::string> warnings = origin.warnings();
    QCOMPARE(warnings.size(), std::size_t{8});
    QVERIFY(warnings.front().find("a reason") != std::string::npos);
    QVERIFY(warnings[3].find("497 more") != std::string::npos);
    QVERIFY(warnings.back().find("297 more") != std::string::npos);
    // A cut that is lost is one that somebody asked for.
    origin.lostCuts = 7;
    warnings = origin.warnings();
    QCOMPARE(warnings.size(), std::size_t{15});
    QVERIFY(warnings.back().find("290 more") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(TestSurfaceStep)
#include "tst_surface_step.moc"

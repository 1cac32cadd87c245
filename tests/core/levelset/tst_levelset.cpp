// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/levelset/evolution.h"
#include "core/levelset/flood.h"
#include "core/levelset/front_speed.h"
#include "core/levelset/packed_front.h"
#include "core/levelset/seeds.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

/// A vesselness that is above a inside a torus, and falls linearly to below 0 outside it.
std::shared_ptr<const Volume<float>> torusVesselness(const Geometry& g) {
  return std::make_shared<const Volume<float>>(sampled(g, [&](const Eigen::Vector3d& x) {
    return std::clamp(0.1 - 0.1 * torus(x, centreOf(g), 9.0, 3.5), -0.3, 0.5);
  }));
}

Thresholds simpleThresholds() {
  Thresholds t;
  t.b = 0.1;
  t.a = 0.2;
  return t;
}

LevelSetEvolution startedTorus(const LevelSetParams& params) {
  const Geometry g = cube(32);
  const Eigen::Vector3d seed = centreOf(g) + Eigen::Vector3d(9.0, 0.0, 0.0);
  return {torusVesselness(g), simpleThresholds(), fastMarchingStart(g, {seed}, 1.0), params};
}

}  // namespace

class TestLevelSet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fastMarchingGivesTheDistanceToSpheres() {
    for (const Geometry& g : {cube(21), oblique(23, 21, 15)}) {
      const Eigen::Vector3d seed = centreOf(g) + Eigen::Vector3d(0.03, -0.11, 0.07);
      const auto phi = fastMarchingStart(g, {seed}, 1.0);
      for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        const double exact = (voxelCentre(g, p) - seed).norm() / g.voxelMm() - 1.0;
        if (exact <= 1.0) QVERIFY(std::fabs(phi.voxels[i] - exact) < 1e-5);
        if (exact < 2.0)
          QVERIFY2(std::fabs(phi.voxels[i] - exact) < 0.6,
                   qPrintable(QString("%1 %2").arg(exact).arg(phi.voxels[i])));
        QVERIFY(phi.voxels[i] <= 4.0F);
      }
    }
  }

  /// Where balls overlap as well each voxel is named once.
  void voxelsAroundSeedsAreNamedOnceInOrder() {
    const Geometry g = oblique(23, 21, 15);
    const std::vector<Eigen::Vector3d> seeds{centreOf(g) + Eigen::Vector3d(0.5, 0.4, 0.9),
                                             centreOf(g), centreOf(g) - Eigen::Vector3d::Ones()};
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < g.voxelCount(); ++i)
      if (std::any_of(seeds.begin(), seeds.end(), [&](const Eigen::Vector3d& seed) {
            return (voxelCentre(g, i) - seed).norm() < 3.1 * g.voxelMm();
          }))
        expected.push_back(i);
    QVERIFY(expected.size() > 100);
    QVERIFY(voxelsAroundSeeds(g, seeds, 3.1) == expected);
  }

  void seedsAreTheBrightestVoxelsAndThoseGiven() {
    const Geometry g = oblique(10, 10, 10);
    Volume<float> v(g, -0.5F);
    v.at(3, 4, 5) = 0.9F;
    v.at(7, 2, 1) = 0.8F;
    v.at(1, 1, 1) = 0.1F;
    SeedParams params;
    params.topPercent = 0.2;
    auto seeds = findSeeds(v, params);
    QCOMPARE(seeds.size(), std::size_t{2});
    QVERIFY((seeds[0] - g.toPhysical({7, 2, 1})).norm() < 1e-9);
    QVERIFY((seeds[1] - g.toPhysical({3, 4, 5})).norm() < 1e-9);
    params.least = 0.85;
    QCOMPARE(findSeeds(v, params).size(), std::size_t{1});
    params.least = 0.95;
    seeds = findSeeds(v, params);
    QCOMPARE(seeds.size(), std::size_t{1});
    QVERIFY((seeds[0] - g.toPhysical({3, 4, 5})).norm() < 1e-9);
    params.least = 0.1;
    const Eigen::Vector3d given = g.toPhysical({2.2, 3.3, 4.4});
    params.points = {given[0], given[1], given[2]};
    QCOMPARE(findSeeds(v, params).size(), std::size_t{3});
    params.automatic = false;
    QCOMPARE(findSeeds(v, params).size(), std::size_t{1});
    params.points = {1000.0, 0.0, 0.0};
    QVERIFY_THROWS_EXCEPTION(InputError, findSeeds(v, params));
    params.points.clear();
    QVERIFY_THROWS_EXCEPTION(NumericError, findSeeds(v, params));
    params.automatic = true;
    QVERIFY_THROWS_EXCEPTION(NumericError, findSeeds(Volume<float>(g, -1.0F), params));
  }

  void curvatureOfABallAndOfATorus() {
    const Geometry g = oblique(61, 53, 33);
    const double unit = g.voxelMm();
    const Volume<float> v(g, 0.0F);
    const FrontSpeed speed(v, simpleThresholds(), 0.7, 0.2, true);
    for (const double radius : {2.5, 5.0}) {
      const auto phi =
          sampled(g, [&](const Eigen::Vector3d& x) { return ball(x, centreOf(g), radius) / unit; });
      for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        if (std::fabs(phi.voxels[i]) > 0.5F || p[0] < 2 || p[1] < 2 || p[2] < 2 || p[0] > 58 ||
            p[1] > 50 || p[2] > 30)
          continue;
        const double at = radius / unit + phi.voxels[i];
        QVERIFY(std::fabs(speed.curvature(phi, i) * at / 2.0 - 1.0) < 0.06);
      }
    }
    const Geometry c = cube(48);
    const Volume<float> w(c, 0.0F);
    const FrontSpeed onCube(w, simpleThresholds(), 0.7, 0.2, true);
    const auto phi =
        sampled(c, [&](const Eigen::Vector3d& x) { return torus(x, centreOf(c), 14.0, 5.0); });
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      if (std::fabs(phi.voxels[i]) > 0.5F) continue;
      const Index3 p = c.indexOf(i);
      const Eigen::Vector3d d = voxelCentre(c, p) - centreOf(c);
      const double ring = std::hypot(d[0], d[1]);
      const double r = 5.0 + phi.voxels[i];
      const double exact = 1.0 / r + (ring - 14.0) / r / ring;
      QVERIFY(std::fabs(onCube.curvature(phi, i) - exact) < 0.02);
    }
  }

  void anExpandingAndAShrinkingBallMoveAtTheirSpeed() {
    for (const Geometry& g : {cube(40), oblique(60, 50, 28)}) {
      const double unit = g.voxelMm();
      for (const double v : {1.0, -1.0}) {
        LevelSetParams params;
        params.gamma = 1.0;  // F = p = +-1
        const double radius = 9.0 * unit;
        const auto phi = sampled(
            g, [&](const Eigen::Vector3d& x) { return ball(x, centreOf(g), radius) / unit; });
        LevelSetEvolution evolution(std::make_shared<const Volume<float>>(g, static_cast<float>(v)),
                                    simpleThresholds(), phi, params);
        const auto equivalentRadius = [&] {
          const double volume = static_cast<double>(evolution.insideVoxels()) * g.voxelVolumeMm3();
          return std::cbrt(volume * 3.0 / 4.0 / M_PI) / unit;
        };
        const double before = equivalentRadius();
        evolution.step(4);
        const double moved = equivalentRadius() - before;
        QVERIFY2(v > 0 ? moved > 0.5 && moved < 3.0 : moved < -0.5 && moved > -3.0,
                 qPrintable(QString::number(moved)));
      }
    }
  }

  void fillsATorusFromOneSeedAndStopsOnItsWall() {
    LevelSetParams params;
    LevelSetEvolution evolution = startedTorus(params);
    evolution.step(5000);
    QVERIFY(evolution.converged());
    QVERIFY(evolution.stopReason() == StopReason::Converged ||
            evolution.stopReason() == StopReason::Settled);
    const Volume<float>& phi = evolution.phi();
    const Geometry& g = phi.geometry;
    double worst = 0.0;
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      const Index3 p = g.indexOf(i);
      const double exact = torus(voxelCentre(g, p), centreOf(g), 9.0, 3.5);
      // The curvature term pushes the wall out by (1 - gamma) d kappa / gamma / (b / 0.1) < 0.1
      // voxel.
      if ((phi.voxels[i] < 0.0F) != (exact < 0.0)) worst = std::max(worst, std::fabs(exact));
    }
    QVERIFY(isBelow(worst, 0.5));
  }

  void chunksEqualOneGoAndThreadsDoNotMatter() {
    LevelSetParams params;
    params.checkEvery = 10;
    setThreads(1);
    LevelSetEvolution atOnce = startedTorus(params);
    atOnce.step(47);
    setThreads(2);
    LevelSetEvolution inChunks = startedTorus(params);
    for (const int n : {1, 2, 9, 15, 20}) inChunks.step(n);
    QCOMPARE(inChunks.iterations(), atOnce.iterations());
    QVERIFY(inChunks.phi().voxels == atOnce.phi().voxels);
    QCOMPARE(inChunks.change(), atOnce.change());
  }

  void neighboursOfOppositeSignAlwaysHaveAnActiveOneBetweenThem() {
    LevelSetEvolution evolution = startedTorus({});
    for (int n = 0; n < 30; ++n) {
      evolution.step(1);
      const Volume<float>& phi = evolution.phi();
      const Geometry& g = phi.geometry;
      for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        if (p[0] + 1 >= g.size[0]) continue;
        const float a = phi.voxels[i];
        const float b = phi.voxels[i + 1];
        if ((a < 0.0F) != (b < 0.0F)) QVERIFY(std::min(std::fabs(a), std::fabs(b)) <= 0.5F);
        QVERIFY(std::fabs(a) <= 3.0F);
      }
    }
  }

  void limitStopsTheEvolution() {
    LevelSetParams params;
    params.maxIterations = 7;
    LevelSetEvolution evolution = startedTorus(params);
    QCOMPARE(evolution.step(100), 7);
    QCOMPARE(evolution.stopReason(), StopReason::Limit);
    QCOMPARE(evolution.step(1), 0);
  }

  /// After three checks in a row whose change is as that before: the first has none before it.
  void threeSteadyChecksSettleTheEvolution() {
    LevelSetParams params;
    params.checkEvery = 2;
    params.tolerance = 0.0;       // no change is small enough
    params.toleranceDelta = 1e9;  // any two changes are alike
    LevelSetEvolution evolution = startedTorus(params);
    QCOMPARE(evolution.step(100), 8);
    QCOMPARE(evolution.stopReason(), StopReason::Settled);
    params.toleranceDelta = 0.0;  // none are
    params.maxIterations = 20;
    LevelSetEvolution restless = startedTorus(params);
    QCOMPARE(restless.step(100), 20);
    QCOMPARE(restless.stopReason(), StopReason::Limit);
  }

  void aSeedOnGroundShrinksToNothing() {
    const Geometry g = cube(16);
    LevelSetEvolution evolution(std::make_shared<const Volume<float>>(g, -0.5F), simpleThresholds(),
                                fastMarchingStart(g, {centreOf(g)}, 1.0), {});
    evolution.step(200);
    QCOMPARE(evolution.insideVoxels(), std::size_t{0});
    QVERIFY(evolution.converged());
  }

  void cancelLeavesTheEvolutionUsable() {
    LevelSetEvolution evolution = startedTorus({});
    evolution.step(5);
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, evolution.step(5, progress));
    evolution.step(5);
    LevelSetEvolution undisturbed = startedTorus({});
    undisturbed.step(10);
    QVERIFY(evolution.phi().voxels == undisturbed.phi().voxels);
  }

  void axesAreAlike_data() {
    QTest::addColumn<bool>("fewAlongLast");
    QTest::newRow("few slices") << true;
    QTest::newRow("many slices") << false;
  }
  void axesAreAlike() {
    QFETCH(bool, fewAlongLast);
    Volume<float> v = unlikeVessels(fewAlongLast);
    for (float& value : v.voxels) value = std::clamp(0.1F - 0.2F * value, -0.3F, 0.5F);
    const Volume<float> other = turned(v);
    const std::vector<Eigen::Vector3d> seed{centreOf(v.geometry)};
    const Volume<float> start = fastMarchingStart(v.geometry, seed, 1.5);
    QVERIFY(mostApart(turned(start), fastMarchingStart(other.geometry, seed, 1.5)) < 1e-4);
    const auto evolved = [](const Volume<float>& speed, const Volume<float>& from) {
      LevelSetParams params;
      LevelSetEvolution evolution(std::make_shared<const Volume<float>>(speed), simpleThresholds(),
                                  from, params);
      evolution.step(40);
      return evolution.takePhi();
    };
    const Volume<float> phi = evolved(v, start);
    QVERIFY(std::count_if(phi.voxels.begin(), phi.voxels.end(),
                          [](float value) { return value < 0.0F; }) > 500);
    // Which neighbour a voxel of the outermost layers first gets its value from depends on the
    // order of memory.
    const Volume<float> first = turned(phi), second = evolved(other, turned(start));
    double apart = 0.0;
    std::size_t near = 0, sides = 0;
    for (std::size_t n = 0; n < first.voxels.size(); ++n) {
      if (std::fabs(first.voxels[n]) > 0.5F) continue;
      ++near;
      apart += std::fabs(first.voxels[n] - second.voxels[n]);
      sides += (first.voxels[n] < 0.0F) != (second.voxels[n] < 0.0F) ? 1 : 0;
    }
    QVERIFY(sides < near / 100);
    QVERIFY(apart < 0.01 * static_cast<double>(near));
    const Volume<std::uint8_t> found = floodVessels(v, 0.1, seed, 1.0, 30);
    QVERIFY(mostApart(turned(found), floodVessels(other, 0.1, seed, 1.0, 30)) == 0.0);
    QVERIFY(mostApart(turned(floodStart(v, 0.1, found)), floodStart(other, 0.1, turned(found))) <
            1e-5);
  }

  void packedFrontsKeepSignsAndValues() {
    LevelSetEvolution evolution = startedTorus({});
    evolution.step(30);
    Volume<float> phi = evolution.phi();
    phi.voxels[5] = -1e-4F;  // would round to the other side
    const PackedFront packed(phi);
    const Volume<float> back = packed.unpacked();
    QVERIFY(back.geometry == phi.geometry);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      QCOMPARE(back.voxels[i] < 0.0F, phi.voxels[i] < 0.0F);
      QVERIFY(std::fabs(back.voxels[i] - std::clamp(phi.voxels[i], -2.5F, 2.5F)) <= 0.0201F);
    }
    QVERIFY(packed.bytes() < phi.voxels.size());
    // Long runs, of which a digit is not enough.
    const Volume<float> far(cube(41), 3.0F);
    QVERIFY(PackedFront(far).unpacked().voxels == Volume<float>(cube(41), 2.5F).voxels);
    QVERIFY(PackedFront(far).bytes() <= 4);
    Geometry row = cube(1);
    for (row.size[0] = 1; row.size[0] < 300; ++row.size[0])
      QCOMPARE(PackedFront(Volume<float>(row, 3.0F)).unpacked().voxels,
               Volume<float>(row, 2.5F).voxels);
  }

  void itIsEndedAfterSoManyIterations() {
    LevelSetParams params;
    params.stopAfter = 7;
    LevelSetEvolution ended = startedTorus(params);
    QCOMPARE(ended.step(5), 5);
    QCOMPARE(ended.stopReason(), StopReason::Running);
    QCOMPARE(ended.step(5), 2);
    QCOMPARE(ended.stopReason(), StopReason::Stopped);
    LevelSetEvolution other = startedTorus({});
    other.step(7);
    QVERIFY(ended.phi().voxels == other.phi().voxels);
  }

  void motionsTellHowFarTheFrontMoved() {
    // A front that p pushes on with speed 1 moves by the largest step, half a voxel.
    const Geometry g = cube(31);
    LevelSetParams params;
    params.gamma = 1.0;
    LevelSetEvolution ball(std::make_shared<const Volume<float>>(g, 1.0F), simpleThresholds(),
                           fastMarchingStart(g, {centreOf(g)}, 3.0), params);
    ball.step(6);
    QCOMPARE(ball.motions().size(), std::size_t{6});
    for (const float motion : ball.motions()) QVERIFY(motion > 0.2F && motion <= 0.5001F);
    // One that has come to rest does not.
    LevelSetEvolution torus = startedTorus({});
    torus.step(400);
    QVERIFY(torus.converged());
    QVERIFY(torus.motions().back() < 0.1F * torus.motions()[5]);
  }
};

QTEST_GUILESS_MAIN(TestLevelSet)
#include "tst_levelset.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/distance/redistance.h"
#include "core/phantom/phantom.h"
#include "core/sensitivity/sensitivity.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

/// Two tubes of 4 mm along x, `other` apart from the first by its radius.
Volume<float> twoTubes(double first, double second) {
  return redistance(clamped(cube(48), [&](const Vector3d& x) {
    return std::min(tube(x, {24.0, 12.0, 23.5}, {1.0, 0.0, 0.0}, first),
                    tube(x, {24.0, 35.0, 23.5}, {1.0, 0.0, 0.0}, second));
  }));
}

}  // namespace

class TestSensitivity : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void movesAreThoseOfTheRadii() {
    const Volume<float> phi = twoTubes(4.0, 3.0);
    const WallPlaces places = wallPlaces(phi);
    QCOMPARE(places.skeleton.branches.size(), std::size_t{2});
    QCOMPARE(places.branch.size(), places.wall.points.size());
    QVERIFY(std::count(places.branch.begin(), places.branch.end(), -1) == 0);
    const Volume<float> other = twoTubes(4.5, 2.8);
    const WallMoves moves = wallMoves(places, phi, other);
    for (std::size_t n = 0; n < places.wall.points.size(); ++n) {
      const double wanted = places.wall.points[n][1] < 24.0 ? 0.5 : -0.2;
      QVERIFY2(std::fabs(moves.movedMm[n] - wanted) < 0.05,
               qPrintable(QString::number(moves.movedMm[n])));
    }
    for (std::size_t b = 0; b < 2; ++b) {
      const bool first = places.skeleton.branches[b].points[0].pointLps[1] < 24.0;
      QVERIFY(std::fabs(moves.branches[b].meanMm - (first ? 0.5 : -0.2)) < 0.03);
      QVERIFY(moves.branches[b].places > 500);
      QCOMPARE(moves.branches[b].lostPercent, 0.0);
    }
    // Places go with the circumference: 4 of 7 on the first.
    QVERIFY(std::fabs(moves.meanMm - (4.0 * 0.5 - 3.0 * 0.2) / 7.0) < 0.02);
    QVERIFY(std::fabs(moves.meanSizeMm - (4.0 * 0.5 + 3.0 * 0.2) / 7.0) < 0.02);
    QVERIFY(std::fabs(moves.p95Mm - 0.5) < 0.05);
    const double before = 16.0 + 9.0, after = 4.5 * 4.5 + 2.8 * 2.8;
    QVERIFY2(std::fabs(moves.volumePercent - 100.0 * (after / before - 1.0)) < 6.0,
             qPrintable(QString::number(moves.volumePercent)));
    const double both = 16.0 + 2.8 * 2.8;
    QVERIFY(std::fabs(moves.overlapPercent - 200.0 * both / (before + after)) < 3.0);
    const WallMoves none = wallMoves(places, phi, phi);
    QVERIFY(none.p95Mm == 0.0 && none.volumePercent == 0.0 && none.overlapPercent == 100.0);
  }

  void aVesselThatIsLostCountsForNoMean() {
    const Volume<float> phi = twoTubes(4.0, 3.0);
    const WallPlaces places = wallPlaces(phi);
    const Volume<float> other = twoTubes(4.25, -6.0);
    const WallMoves moves = wallMoves(places, phi, other);
    QVERIFY(std::fabs(moves.lostPercent - 300.0 / 7.0) < 1.0);
    QVERIFY(std::fabs(moves.meanMm - 0.25) < 0.02);
    for (std::size_t n = 0; n < places.wall.points.size(); ++n)
      if (places.wall.points[n][1] > 24.0) QCOMPARE(moves.movedMm[n], -4.0F);
    for (std::size_t b = 0; b < 2; ++b)
      QCOMPARE(moves.branches[b].lostPercent,
               places.skeleton.branches[b].points[0].pointLps[1] < 24.0 ? 0.0 : 100.0);
  }

  void stepsGoUpAndDown() {
    Parameters params;
    FieldContext context;
    context.voxelMm = 0.5;
    const std::vector<ParameterStep> steps = parameterSteps(params, context);
    std::map<std::string, std::vector<const ParameterStep*>> byKey;
    for (const ParameterStep& step : steps) byKey[step.key].push_back(&step);
    QVERIFY(byKey.count("levelset.xi") == 1 && byKey.count("vesselness.sigmaMinMm") == 1);
    QVERIFY(byKey.count("surface.rho") == 0 && byKey.count("segmentation.label") == 0);
    for (const auto& [key, both] : byKey) {
      const Field& field = findField(key);
      QVERIFY(both.size() <= 2);
      for (const ParameterStep* step : both) {
        QCOMPARE(step->to > step->from, step->up);
        QVERIFY(step->to >= field.minimum && step->to <= field.maximum);
        QVERIFY(!(step->params == params));
      }
      if (both.size() == 2) QCOMPARE(both[0]->from, both[1]->from);
    }
    // What is computed last comes first.
    for (std::size_t n = 1; n < steps.size(); ++n)
      QVERIFY(*findField(steps[n].key).ofScan <= *findField(steps[n - 1].key).ofScan);
    const auto& sigma = byKey["vesselness.sigmaMinMm"];
    for (const ParameterStep* step : sigma)
      QVERIFY(std::fabs(step->to / step->from - (step->up ? 1.25 : 0.8)) < 1e-6);
    // Twice as far, or twice by the factor.
    for (const char* key : {"levelset.xi", "levelset.gamma"})
      for (const ParameterStep& step : parameterSteps(params, context, {key}, 2.0))
        for (const ParameterStep* one : byKey[key]) {
          if (one->up != step.up) continue;
          const double once = one->to / one->from, further = one->to - one->from;
          QVERIFY(std::fabs(step.to - (findField(key).logarithmic ? step.from * once * once
                                                                  : step.from + 2.0 * further)) <
                  1e-6);
        }
    QVERIFY_THROWS_EXCEPTION(InputError, parameterSteps(params, context, {"surface.rho"}));
    QVERIFY_THROWS_EXCEPTION(InputError, parameterSteps(params, context, {"levelset.start"}));
    QVERIFY_THROWS_EXCEPTION(InputError, parameterSteps(params, context, {"levelset.nothing"}));
  }

  void eachStepIsWhatARunGives() {
    PhantomParams phantom;
    phantom.size = {48, 48, 48};
    phantom.noiseSigma = 10.0;
    const Source source = makeSource(makePhantom(phantom).image, "tree");
    Pipeline pipeline(source);
    Parameters params;
    FieldContext context;
    context.voxelMm = source.image->geometry.voxelMm();
    const std::vector<ParameterStep> steps =
        parameterSteps(params, context, {"levelset.refineLevel", "vesselness.sigmaMinMm"});
    QVERIFY(steps.size() >= 3);
    std::set<std::size_t> told;
    const Sensitivity found =
        sensitivityOf(pipeline, params, steps, {}, [&](std::size_t n) { told.insert(n); });
    QCOMPARE(told.size(), steps.size());
    QCOMPARE(found.effects.size(), steps.size());
    RunOptions until;
    until.until = Step::Correct;
    for (const StepEffect& effect : found.effects) {
      QVERIFY2(effect.why.empty(), effect.why.c_str());
      Pipeline alone(source);
      const RunResult run = alone.run(effect.step.params, until);
      const WallMoves moves =
          wallMoves(found.places, *found.segmentation->phi, *run.segmentation()->phi);
      QVERIFY(moves.movedMm == effect.moves.movedMm);
      for (std::size_t v = 0; v < found.spreadMm.size(); ++v)
        QVERIFY(found.spreadMm[v] >= std::fabs(moves.movedMm[v]));
    }
    // A higher level puts the wall farther in.
    for (const StepEffect& effect : found.effects)
      if (effect.step.key == "levelset.refineLevel" && effect.step.up)
        QVERIFY(effect.moves.volumePercent <= 0.0);
  }
};

QTEST_GUILESS_MAIN(TestSensitivity)
#include "tst_sensitivity.moc"

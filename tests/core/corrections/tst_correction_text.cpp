// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/corrections/correction.h"
#include "core/corrections/replay.h"
#include "core/distance/redistance.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

/// A tree that is segmented in a moment.
Source smallTree() {
  PhantomParams params;
  params.size = {48, 48, 48};
  return makeSource(makePhantom(params).image, "scan");
}

RunResult runUntil(Pipeline& pipeline, const Parameters& params, Step until) {
  RunOptions options;
  options.until = until;
  return pipeline.run(params, options);
}

}  // namespace

class TestCorrectionText : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textsAreReadAsTheyAreWritten_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"add 1.5 1,2,3", "add-to-edge 0.25 -1.125,2,3 4,5,6 7,8,9.001",
                             "erase 100 0,0,0", "erase-to-edge 2 1,1,1", "bridge 1,2,3 4,5,6",
                             "separate 1,2,3 4,5,6.5", "cut-off 1,2,3 0.00000,-1.00000,0.00000",
                             "cut-off 1,2,3", "fill-hole 1,2,3", "open-loop -1e+05,2,3"})
      QTest::newRow(text) << text;
  }
  void textsAreReadAsTheyAreWritten() {
    QFETCH(QString, text);
    const Correction correction = parseCorrection(text.toStdString());
    QCOMPARE(QString::fromStdString(correctionText(correction)), text);
    QCOMPARE(parseCorrection(correctionText(correction)), correction);
    QCOMPARE(isBrush(correction.kind), correction.radiusMm > 0.0);
  }

  void placesAreWrittenToAMicrometre() {
    Correction correction{CorrectionKind::Add, 1.0 / 3.0, {{-0.0001, 1.23456, 2e-9}}, {0, 0, 0}};
    QCOMPARE(correctionText(correction), std::string("add 0.333 0,1.235,0"));
  }

  void whatIsNoCorrectionIsRefused_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"",
                             "paint 1 1,2,3",
                             "add",
                             "add 1",
                             "add 0 1,2,3",
                             "add -1 1,2,3",
                             "add 101 1,2,3",
                             "add nan 1,2,3",
                             "add 1 1,2",
                             "add 1 1,2,3,4",
                             "add 1 1,2,x",
                             "add 1 1,2,inf",
                             "add 1 1,2,1e6",
                             "bridge 1,2,3",
                             "bridge 1,2,3 4,5,6 7,8,9",
                             "separate 1,2,3",
                             "cut-off",
                             "cut-off 1,2,3 4,5,6 7,8,9",
                             "cut-off 1,2,3 0,0,0",
                             "fill-hole",
                             "fill-hole 1,2,3 4,5,6",
                             "open-loop 1 1,2,3",
                             "Add 1 1,2,3"})
      QTest::newRow(text) << text;
  }
  void whatIsNoCorrectionIsRefused() {
    QFETCH(QString, text);
    QVERIFY_THROWS_EXCEPTION(InputError, parseCorrection(text.toStdString()));
    Parameters params;
    QVERIFY_THROWS_EXCEPTION(InputError, setField(params, "segmentation.corrections",
                                                  std::vector<std::string>{text.toStdString()}));
  }

  void whatCannotBeMadeIsLeftOutAndToldOf() {
    const Geometry g = cube(24);
    Volume<float> phi = redistance(clamped(g, [](const Eigen::Vector3d& x) {
      return ball(x, {8.0, 8.0, 8.0}, 4.0);
    }));
    const Volume<float> before = phi;
    const std::vector<std::string> texts{"bridge 8,8,8 20,20,20", "add 2 8,8,8", "add 3 16,16,16"};
    const std::vector<CorrectionOutcome> outcomes = replay(phi, texts, {});
    QCOMPARE(outcomes.size(), std::size_t{3});
    QVERIFY(!outcomes[0].why.empty() && outcomes[1].why.empty() && outcomes[2].why.empty());
    QCOMPARE(outcomes[1].added, std::size_t{0});
    QVERIFY(outcomes[2].added > 80);
    const std::vector<std::string> warnings = warningsOf(outcomes);
    QCOMPARE(warnings.size(), std::size_t{2});
    QVERIFY(warnings[0].starts_with("correction 1 (bridge) was left out: there is no vessel"));
    QCOMPARE(warnings[1], std::string("correction 2 (add) changed nothing"));
    // One after another is the same as all at once.
    Volume<float> again = before;
    for (const std::string& text : texts) (void)replay(again, {text}, {});
    QVERIFY(again.voxels == phi.voxels);
  }

  void theVoxelsFollow() {
    const Geometry g = cube(4);
    Volume<float> before(g, 1.0F), after = before, other(g, 0.5F);
    after.voxels[3] = -1.0F;
    after.voxels[5] = 2.0F;
    other.voxels[5] = -0.25F;
    other.voxels[7] = -3.0F;
    carryOver(before, after, other);
    QCOMPARE(other.voxels[3], -1.0F);
    QCOMPARE(other.voxels[5], 2.0F);
    QCOMPARE(other.voxels[7], -3.0F);
    QCOMPARE(other.voxels[0], 0.5F);
  }

  void theStepMakesWhatIsNewAndKeepsTheRest() {
    Pipeline pipeline(smallTree());
    Parameters params;
    const RunResult plain = runUntil(pipeline, params, Step::Correct);
    QVERIFY(plain.corrected == plain.evolve);
    QCOMPARE(pipeline.key(Step::Correct, params), pipeline.key(Step::Evolve, params));
    const std::string meshKey = pipeline.key(Step::Smooth, params);

    const auto placeOf = [](const Eigen::Vector3d& x) {
      return shortestText(x[0]) + "," + shortestText(x[1]) + "," + shortestText(x[2]);
    };
    const Geometry& g = plain.evolve->phi->geometry;
    std::vector<std::string>& texts = params.segmentation.corrections;
    texts = {"add 1.5 " + placeOf(g.toPhysical({8.0, 8.0, 8.0}))};
    QCOMPARE(pipeline.key(Step::Evolve, params), pipeline.key(Step::Evolve, plain.params));
    QVERIFY(pipeline.key(Step::Smooth, params) != meshKey);
    const RunResult one = runUntil(pipeline, params, Step::Correct);
    QVERIFY(one.evolve == plain.evolve && one.corrected != one.evolve);
    texts.push_back("erase 1 " + placeOf(g.toPhysical({8.0, 8.0, 8.0})));
    const RunResult two = runUntil(pipeline, params, Step::Correct);
    QCOMPARE(two.corrected->corrections.size(), std::size_t{2});
    QCOMPARE(two.corrected->corrections[0], one.corrected->corrections[0]);
    // The same bits without anything at hand.
    Pipeline fresh(smallTree());
    const RunResult again = runUntil(fresh, params, Step::Correct);
    QVERIFY(again.corrected->phi->voxels == two.corrected->phi->voxels);
    QVERIFY(again.evolve->phi->voxels == plain.evolve->phi->voxels);
    // Taken back it is what it was.
    texts.clear();
    QVERIFY(runUntil(pipeline, params, Step::Correct).corrected == plain.evolve);
  }
};

QTEST_GUILESS_MAIN(TestCorrectionText)
#include "tst_correction_text.moc"

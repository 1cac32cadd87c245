// SPDX-License-Identifier: BSD-3-Clause
#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "gui/model/case_models.h"
#include "gui/model/result_text.h"
#include "gui/model/step_text.h"
#include "tests/gui/small_case.h"

using namespace angiomesh;
using angiomesh::test::evolveFor;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;

namespace {

constexpr int kPatienceMs = 60000;

QString contour(const CaseModels& models) { return contourText(models.results, models.runs).text; }

QString surface(const CaseModels& models) {
  return surfaceText(models.results, models.runs, MeshKind::Exported).text;
}

}  // namespace

/// Which result is shown, and what is said of it.
class TestResults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(settings_.isValid());
    QCoreApplication::setOrganizationName("AngiomeshTest");
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
  }
  void init() { QSettings().clear(); }

  void resultsKeepTheirNames() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    QCOMPARE(contour(models), QString());
    QCOMPARE(surface(models), QString());
    models.runs.run();
    QCOMPARE(contour(models), QString("Result 1"));
    QCOMPARE(surface(models), QString("Result 1\nexported (smoothed)"));
    models.document.setField("levelset.xi", 35.0);
    QCOMPARE(contour(models), QString("Result 1, out of date"));
    QVERIFY(contourText(models.results, models.runs).stale);
    QVERIFY(meshText(models.results).stale);
    models.runs.run();
    QCOMPARE(contour(models), QString("Result 2"));
    QVERIFY(!contourText(models.results, models.runs).stale);
    models.document.setField("smooth.iterations", std::int64_t(3));
    QCOMPARE(contour(models), QString("Result 2"));
    QCOMPARE(meshText(models.results).text, QString("Result 2, out of date"));
    models.runs.run();
    QCOMPARE(meshText(models.results).text, QString("Result 2b"));
    models.document.undoStack()->undo();
    QCOMPARE(meshText(models.results).text, QString("Result 2"));
    models.document.undoStack()->undo();
    QCOMPARE(contour(models), QString("Result 1"));
    QCOMPARE(meshText(models.results).text, QString("Result 1"));
    models.files.take(twoTubes(36));
    QCOMPARE(meshText(models.results).text, QString());
    models.runs.run();
    QCOMPARE(contour(models), QString("Result 1"));
  }

  void letters() {
    ResultNames names;
    QCOMPARE(names.segmentation("x"), 1);
    QCOMPARE(names.segmentation(""), 2);
    QCOMPARE(names.segmentation(""), 3);
    QCOMPARE(names.segmentation("x"), 1);
    QString last;
    for (int i = 0; i < 28; ++i) last = names.mesh(1, std::to_string(i));
    QCOMPARE(last, QString("1bb"));
    QCOMPARE(names.mesh(1, "25"), QString("1z"));
    QCOMPARE(names.mesh(3, "25"), QString("3"));
  }

  /// The slices and the 3D pane never show two segmentations.
  void aSegmentationWithoutAMeshIsOutlined() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.runs.run();
    QVERIFY(models.results.meshFits());
    QVERIFY(models.results.outline() == nullptr);
    models.document.setField("levelset.xi", 35.0);
    models.runs.run(Step::Evolve);
    QVERIFY(!models.results.meshFits());
    QVERIFY(models.results.mesh(MeshKind::Exported) != nullptr);
    QCOMPARE(meshText(models.results).text, QString("Result 1, out of date"));
    QCOMPARE(surface(models), QString("Result 2, no mesh yet"));
    const std::shared_ptr<const TriMesh> outline = models.results.outline();
    QVERIFY(outline && !outline->triangles.empty());
    QVERIFY(models.results.outline() == outline);
    const Volume<float>& phi = *models.results.phi();
    QVERIFY(models.results.phi() == models.results.evolveResult()->phi);
    for (const Eigen::Vector3d& point : outline->points) {
      const Eigen::Vector3d index = phi.geometry.toIndex(point).array().round();
      if (index.minCoeff() < 1.0 || index.maxCoeff() > 38.0) continue;  // of a cap
      const double value = phi.at(static_cast<int>(index[0]), static_cast<int>(index[1]),
                                  static_cast<int>(index[2]));
      QVERIFY(std::abs(value) < 0.9 * phi.geometry.voxelMm());
    }
    models.runs.run();
    QVERIFY(models.results.meshFits());
    QVERIFY(models.results.outline() == nullptr);
    QCOMPARE(surface(models), QString("Result 2\nexported (smoothed)"));
  }

  void aFailedSurfaceLeavesTheOutline() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.document.setField("surface.maxTriangles", std::int64_t(100));
    models.runs.run();
    QVERIFY(models.runs.state(Step::Surface) == StepState::Failed);
    QCOMPARE(contour(models), QString("Result 1"));
    QCOMPARE(surface(models), QString("Result 1, no mesh yet"));
    QVERIFY(models.results.outline() != nullptr);
  }

  /// The same parameters, and two results.
  void anEvolutionEndedByHandIsAResultOfItsOwn() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    evolveFor(models);
    models.runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(models.results.live(), kPatienceMs);
    QVERIFY2(contour(models).startsWith("Evolving, iteration "), qPrintable(contour(models)));
    QCOMPARE(surface(models), contour(models));
    models.runs.finishEvolution();
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QCOMPARE(contour(models), QString("Result 1"));
    models.document.setField("levelset.maxIterations", std::int64_t(40));
    models.runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QCOMPARE(contour(models), QString("Result 2"));
    models.document.undoStack()->undo();
    QCOMPARE(contour(models), QString("Result 2, out of date"));
    // The parameters of the first one again, ended elsewhere.
    models.runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(models.results.live(), kPatienceMs);
    models.runs.finishEvolution();
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QCOMPARE(contour(models), QString("Result 3"));
  }

  void timeLeftIsSaidAsWellAsItIsKnown() {
    QCOMPARE(durationText(0.4), QString("a few seconds"));
    QCOMPARE(durationText(12.0), QString("about 10 s"));
    QCOMPARE(durationText(53.0), QString("about 55 s"));
    QCOMPARE(durationText(88.0), QString("about 90 s"));
    QCOMPARE(durationText(100.0), QString("about 2 min"));
  }

  /// The bar of a step and that of the run never fall, and each step moves its own.
  void progressOnlyRises() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    double last = 0.0;
    bool fell = false;
    double evolved = 0.0;
    connect(&models.timer, &JobTimer::ticked, this, [&] {
      if (!models.runs.running()) return;
      fell = fell || models.runs.runFraction() < last;
      last = models.runs.runFraction();
      if (models.runs.stepInWork() == Step::Evolve && models.results.live())
        evolved = std::max(evolved, models.runs.stepFraction());
    });
    models.document.setField("levelset.checkEvery", std::int64_t(2));
    models.runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QVERIFY(models.runs.state(Step::Quality) == StepState::Fresh);
    QVERIFY(!fell && last > 0.5);
    QVERIFY(evolved > 0.0);
    QVERIFY(!models.runs.secondsLeft());
  }

  void layersSayWhatTheyAre() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    QCOMPARE(layerText(models.results, Layer::Source, true).text, QString("Source"));
    QCOMPARE(layerText(models.results, Layer::Vesselness, false).text,
             QString("Source (no vesselness yet)"));
    models.runs.run(Step::Vesselness);
    QVERIFY(models.results.layer(Layer::Speed) != nullptr);
    for (const Layer layer : {Layer::Vesselness, Layer::Speed})
      QVERIFY(!layerText(models.results, layer, true).stale);
    models.document.setField("vesselness.alpha", 0.6);
    for (const Layer layer : {Layer::Vesselness, Layer::Speed})
      QVERIFY(layerText(models.results, layer, true).stale);
    QCOMPARE(layerText(models.results, Layer::Vesselness, true).text,
             QString("Vesselness, out of date"));
    QVERIFY(!layerText(models.results, Layer::Preprocessed, true).stale);
  }

  void theNextPatientBeginsWithAPreset() {
    CaseModels models(makeInlineJobRunner);
    models.presets.apply("thesis");
    models.files.take(twoTubes());
    QCOMPARE(models.presets.current(), QString("thesis"));  // chosen for this one
    models.document.setField("levelset.xi", 35.0);
    models.document.addSeed({1.0, 2.0, 3.0});
    models.files.take(twoTubes(36));
    QVERIFY(models.document.parameters() == preset("angiomesh"));
    models.presets.apply("thesis");
    models.document.setField("levelset.xi", 35.0);
    models.files.take(twoTubes());
    QVERIFY(models.document.parameters() == preset("thesis"));
  }

 private:
  QTemporaryDir settings_;
};

QTEST_GUILESS_MAIN(TestResults)
#include "tst_results.moc"

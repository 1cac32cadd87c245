// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "gui/model/case_controller.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "small_case.h"

using namespace angiomesh;
using angiomesh::test::evolveFor;
using angiomesh::test::kLongEvolution;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;

namespace {

constexpr int kPatienceMs = 60000;

/// The messages of a controller, by severity.
struct Messages {
  explicit Messages(CaseController& controller) {
    QObject::connect(&controller, &CaseController::message, &controller,
                     [this](Severity severity, const QString& text) {
                       (severity == Severity::Error ? errors : others) << text;
                     });
  }
  QStringList errors, others;
};

}  // namespace

class TestController : public QObject {
  Q_OBJECT

 private:
  static void verifyStates(const CaseController& controller, Step firstStale, StepState after) {
    for (int i = static_cast<int>(Step::Preprocess); i < kStepCount; ++i) {
      const Step step = static_cast<Step>(i);
      QVERIFY2(controller.state(step) == (step < firstStale ? StepState::Fresh : after),
               stepId(step));
    }
  }

 private Q_SLOTS:
  void runsAllSteps() {
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.take(twoTubes());
    QVERIFY(controller.hasCase());
    QVERIFY(controller.state(Step::Vesselness) == StepState::Empty);
    controller.run();
    QVERIFY2(messages.errors.isEmpty(), qPrintable(messages.errors.join('\n')));
    verifyStates(controller, static_cast<Step>(kStepCount), StepState::Stale);
    QCOMPARE(controller.components().size(), std::size_t(2));
    QVERIFY(controller.quality(MeshKind::Exported)->closed);
    QCOMPARE(controller.facts()->minAnglesDeg[0].size(),
             controller.mesh(MeshKind::Exported)->triangles.size());
    QVERIFY(controller.layer(Layer::Speed) != nullptr);
    QVERIFY(controller.seconds(Step::Vesselness) > 0.0);
  }

  void runsUpToAStep() {
    CaseController controller(makeInlineJobRunner);
    controller.take(twoTubes());
    controller.run(Step::Vesselness);
    verifyStates(controller, Step::Seeds, StepState::Empty);
  }

  void changesReachTheStepsThatDependOnThemOnly() {
    CaseController controller(makeInlineJobRunner);
    controller.take(twoTubes());
    controller.run();
    controller.setField("levelset.xi", 35.0);
    verifyStates(controller, Step::Evolve, StepState::Stale);
    controller.undoStack()->undo();
    verifyStates(controller, static_cast<Step>(kStepCount), StepState::Stale);
    controller.undoStack()->redo();
    controller.run();
    const auto after = controller.mesh(MeshKind::Exported);
    controller.undoStack()->undo();
    verifyStates(controller, static_cast<Step>(kStepCount), StepState::Stale);
    QVERIFY(controller.mesh(MeshKind::Exported) != after);
    controller.undoStack()->redo();
    QVERIFY(controller.mesh(MeshKind::Exported) == after);
  }

  void aDragIsOneEdit() {
    CaseController controller(makeInlineJobRunner);
    controller.setField("levelset.gamma", 0.5, false);
    controller.setField("levelset.gamma", 0.4, true);
    controller.setField("levelset.gamma", 0.3, true);
    controller.setField("levelset.gamma", 0.2, false);
    QCOMPARE(controller.undoStack()->count(), 2);
    controller.undoStack()->undo();
    QCOMPARE(controller.parameters().levelset.gamma, 0.3);
    controller.undoStack()->undo();
    QCOMPARE(controller.parameters().levelset.gamma, 0.7);
  }

  void valuesOutOfRangeAreRefused() {
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.setField("levelset.gamma", 7.0);
    QCOMPARE(messages.errors.size(), 1);
    QVERIFY(messages.errors.first().contains("levelset.gamma"));
    QCOMPARE(controller.parameters().levelset.gamma, 0.7);
    QCOMPARE(controller.undoStack()->count(), 0);
  }

  void boundsPushEachOther() {
    CaseController controller(makeInlineJobRunner);
    controller.setField("vesselness.sigmaMinMm", 1.0);
    controller.setField("vesselness.sigmaMaxMm", 3.0);
    controller.setField("vesselness.sigmaMinMm", 4.0);
    QCOMPARE(*controller.parameters().vesselness.sigmaMaxMm, 4.0);
  }

  void presetsKeepPlaces() {
    CaseController controller(makeInlineJobRunner);
    QCOMPARE(controller.presetName(), QString("angiomesh"));
    controller.addSeed({1.0, 2.0, 3.0});
    QCOMPARE(controller.presetName(), QString("angiomesh"));
    controller.applyPreset("thesis");
    QCOMPARE(controller.presetName(), QString("thesis"));
    QCOMPARE(controller.seeds().size(), std::size_t(1));
    controller.setField("levelset.d", 0.3);
    QCOMPARE(controller.presetName(), QString());
  }

  void aFailureNamesItsStep() {
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.take(twoTubes());
    controller.setField("levelset.b", 1.0);
    controller.run();
    QVERIFY(controller.state(Step::Evolve) == StepState::Failed);
    QVERIFY(controller.state(Step::Seeds) == StepState::Fresh);
    QVERIFY(!controller.failure(Step::Evolve).isEmpty());
    QCOMPARE(messages.errors.size(), 1);
    controller.setField("levelset.b", 0.1);
    QVERIFY(controller.state(Step::Evolve) == StepState::Empty);
    QVERIFY(controller.failure(Step::Evolve).isEmpty());
  }

  /// A surface that is not begun costs nothing of what was computed before it.
  void aRefusedSurfaceKeepsTheEvolution() {
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.take(twoTubes());
    controller.setField("surface.maxTriangles", std::int64_t(100));
    controller.run();
    QVERIFY(controller.state(Step::Surface) == StepState::Failed);
    QVERIFY(controller.state(Step::Evolve) == StepState::Fresh);
    const QString why = controller.failure(Step::Surface);
    QVERIFY2(why.contains("surface.edgeMinMm") && why.contains("surface.maxTriangles"),
             qPrintable(why));
    QCOMPARE(controller.expectationWarnings().size(), 1);
    controller.setField("surface.maxTriangles", std::int64_t(0));
    QVERIFY(controller.expectationWarnings().isEmpty());
    controller.run();
    QVERIFY(controller.state(Step::Quality) == StepState::Fresh);
  }

  void aRunWithoutSeedsSaysSo() {
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.take(twoTubes());
    controller.setField("seeds.automatic", false);
    QVERIFY(messages.errors.isEmpty());
    controller.run();
    QVERIFY(controller.state(Step::Seeds) == StepState::Failed);
    QCOMPARE(messages.errors.size(), 1);
    const auto along = controller.image()->geometry.toPhysical({20.0, 20.0, 20.0});
    controller.addSeed(along);
    QVERIFY(controller.state(Step::Seeds) == StepState::Empty);
  }

  void seedsGoAndComeBack() {
    CaseController controller(makeInlineJobRunner);
    controller.take(twoTubes());
    controller.addSeed({1.0, 2.0, 3.0});
    controller.addSeed({4.0, 5.0, 6.0});
    controller.removeSeed(0);
    QCOMPARE(controller.seeds().size(), std::size_t(1));
    QCOMPARE(controller.seeds().front(), Eigen::Vector3d(4.0, 5.0, 6.0));
    controller.undoStack()->undo();
    QCOMPARE(controller.seeds().size(), std::size_t(2));
    controller.removeSeed(9);
    QCOMPARE(controller.seeds().size(), std::size_t(2));
  }

  void aRegionOutsideTheImageIsRefused() {
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.take(twoTubes());
    controller.setRoi(std::array<double, 6>{500, 500, 500, 600, 600, 600});
    QCOMPARE(messages.errors.size(), 1);
    QVERIFY(!controller.parameters().preprocess.roi);
    controller.setRoi(std::array<double, 6>{0, 0, 0, 20, 20, 8});
    controller.run(Step::Preprocess);
    QVERIFY(controller.layer(Layer::Preprocessed)->geometry.size[2] < 20);
  }

  void partsAreTickedOffAndOn() {
    CaseController controller(makeInlineJobRunner);
    controller.take(twoTubes());
    controller.run();
    const std::size_t both = controller.mesh(MeshKind::Exported)->triangles.size();
    controller.setComponentTicked(1, false);
    verifyStates(controller, Step::Surface, StepState::Stale);
    QVERIFY(!controller.components()[1].ticked);
    controller.run();
    QVERIFY(controller.mesh(MeshKind::Exported)->triangles.size() < both);
    QCOMPARE(controller.components().size(), std::size_t(2));
    QVERIFY(!controller.components()[1].ticked);
    QVERIFY(!controller.components()[1].byRule);
    controller.setComponentTicked(1, true);
    QVERIFY(controller.components()[1].ticked);
    QVERIFY(controller.meshFresh());
    QCOMPARE(controller.mesh(MeshKind::Exported)->triangles.size(), both);
  }

  void aPartLeftOutByRuleHasNoTick() {
    CaseController controller(makeInlineJobRunner);
    controller.take(twoTubes());
    controller.setField("segmentation.keep", std::string("largest"));
    controller.run();
    QVERIFY(controller.components()[0].ticked);
    QVERIFY(controller.components()[1].byRule);
    QVERIFY(!controller.components()[1].ticked);
  }

  void badFilesLeaveTheCaseAlone() {
    const QTemporaryDir folder;
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.take(twoTubes());
    const QString path = folder.filePath("Doe_John.mha");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is not an image");
    file.close();
    controller.open(path);
    controller.open(folder.filePath("missing.nii.gz"));
    controller.open(folder.path());
    QCOMPARE(messages.errors.size(), 3);
    for (const QString& error : messages.errors) {
      QVERIFY2(!error.contains(folder.path()), qPrintable(error));
    }
    QCOMPARE(controller.caseName(), QString("two-tubes"));
  }

  void anotherCaseKeepsParametersButNoPlaces() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scan.nii.gz");
    writeVolume(*twoTubes().image, path.toStdString());
    CaseController controller(makeInlineJobRunner);
    controller.take(twoTubes());
    controller.setField("levelset.xi", 33.0);
    controller.addSeed({1.0, 2.0, 3.0});
    controller.run(Step::Preprocess);
    QSignalSpy opened(&controller, &CaseController::opened);
    controller.open(path);
    QCOMPARE(opened.size(), 1);
    QCOMPARE(controller.caseName(), QString("scan"));
    QCOMPARE(controller.parameters().thresholds.xi, 33.0);
    QVERIFY(controller.seeds().empty());
    QVERIFY(controller.state(Step::Preprocess) == StepState::Empty);
    QCOMPARE(controller.undoStack()->count(), 0);
  }

  void exportsMeshAndReport() {
    const QTemporaryDir folder;
    CaseController controller(makeInlineJobRunner);
    Messages messages(controller);
    controller.exportMesh(MeshKind::Exported, folder.filePath("none.ply"), {}, {});
    QCOMPARE(messages.errors.size(), 1);
    controller.take(twoTubes());
    controller.run();
    controller.exportMesh(MeshKind::Exported, folder.filePath("a.ply"), {}, {.report = true});
    QVERIFY(QFile::exists(folder.filePath("a.report.json")));
    const TriMesh back = readMesh(folder.filePath("a.ply").toStdString());
    QCOMPARE(back.triangles.size(), controller.mesh(MeshKind::Exported)->triangles.size());
    const QString triangles = QString("%1 triangles, closed").arg(back.triangles.size());
    QVERIFY2(messages.others.last().contains(triangles), qPrintable(messages.others.last()));
    controller.exportMesh(MeshKind::Exported, folder.filePath("no/such/a.stl"), {}, {});
    QCOMPARE(messages.errors.size(), 2);
    QVERIFY(!messages.errors.last().contains(folder.path()));
  }

  void theEvolutionIsWatched() {
    CaseController controller;
    controller.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(controller.hasCase(), kPatienceMs);
    evolveFor(controller);
    QSignalSpy snapshots(&controller, &CaseController::snapshotArrived);
    controller.run();
    QTRY_VERIFY_WITH_TIMEOUT(snapshots.size() > 2, kPatienceMs);
    QVERIFY(controller.evolving());
    QVERIFY(controller.liveSurface() && !controller.liveSurface()->triangles.empty());
    QVERIFY(controller.state(Step::Evolve) == StepState::Running);
    QTRY_VERIFY_WITH_TIMEOUT(controller.history().size() > 2, kPatienceMs);

    controller.setPaused(true);
    QTRY_VERIFY_WITH_TIMEOUT(controller.paused(), kPatienceMs);
    int before = -1;
    // The worker ends the chunk in hand before it pauses.
    QTRY_VERIFY_WITH_TIMEOUT(
        std::exchange(before, controller.iterations()) == controller.iterations(), kPatienceMs);
    controller.stepEvolution(7);
    QTRY_VERIFY_WITH_TIMEOUT(controller.iterations() >= before + 7, kPatienceMs);

    controller.finishEvolution();
    QTRY_VERIFY_WITH_TIMEOUT(!controller.running(), kPatienceMs);
    QVERIFY(controller.state(Step::Quality) == StepState::Fresh);
    QVERIFY(controller.results().evolve->stopReason == StopReason::Stopped);
    QVERIFY(controller.results().evolve->iterations > 0);
    QVERIFY(!controller.liveSurface());
  }

  void aChangeInMidRunRestarts() {
    CaseController controller;
    controller.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(controller.hasCase(), kPatienceMs);
    evolveFor(controller);
    controller.run();
    QTRY_VERIFY_WITH_TIMEOUT(controller.evolving() && controller.iterations() > 0, kPatienceMs);
    const auto vesselness = controller.vesselnessResult();
    controller.setField("levelset.maxIterations", std::int64_t(40));
    QTRY_VERIFY_WITH_TIMEOUT(!controller.running(), kPatienceMs);
    QVERIFY(controller.state(Step::Quality) == StepState::Fresh);
    QCOMPARE(controller.results().evolve->iterations, 40);
    QVERIFY(controller.vesselnessResult() == vesselness);
  }

  void aChangeBehindTheStepInWorkLetsItGoOn() {
    CaseController controller;
    controller.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(controller.hasCase(), kPatienceMs);
    evolveFor(controller, kLongEvolution);
    controller.run();
    QTRY_VERIFY_WITH_TIMEOUT(controller.evolving() && controller.iterations() > 0, kPatienceMs);
    int most = controller.iterations();
    bool fellBack = false;
    connect(&controller, &CaseController::progressChanged, this, [&] {
      fellBack = fellBack || controller.iterations() < most;
      most = controller.iterations();
    });
    controller.setField("smooth.iterations", std::int64_t(3));
    QTRY_VERIFY_WITH_TIMEOUT(!controller.running(), kPatienceMs);
    QVERIFY(!fellBack);
    QVERIFY(controller.state(Step::Quality) == StepState::Fresh);
  }

  void cancelActsSoonAndLeavesTheProgramUsable() {
    CaseController controller;
    controller.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(controller.hasCase(), kPatienceMs);
    evolveFor(controller);
    controller.run();
    QTRY_VERIFY_WITH_TIMEOUT(controller.evolving(), kPatienceMs);
    controller.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!controller.running(), 2000);
    QVERIFY(controller.state(Step::Evolve) == StepState::Empty);
    QVERIFY(controller.state(Step::Seeds) == StepState::Fresh);
    QVERIFY(!controller.liveSurface());
    controller.setField("levelset.maxIterations", std::int64_t(20));
    controller.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(!controller.running(), kPatienceMs);
    QVERIFY(controller.state(Step::Evolve) == StepState::Fresh);
  }

  void aCaseOpenedInMidRunTakesOver() {
    CaseController controller;
    controller.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(controller.hasCase(), kPatienceMs);
    evolveFor(controller);
    controller.run();
    QTRY_VERIFY_WITH_TIMEOUT(controller.evolving(), kPatienceMs);
    controller.take(twoTubes());
    QTRY_COMPARE_WITH_TIMEOUT(controller.caseName(), QString("two-tubes"), kPatienceMs);
    QVERIFY(!controller.running());
    QVERIFY(controller.state(Step::Vesselness) == StepState::Empty);
    QVERIFY(!controller.phi());
  }

  void goesWhileRunning() {
    auto controller = std::make_unique<CaseController>();
    controller->take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(controller->hasCase(), kPatienceMs);
    evolveFor(*controller);
    controller->run();
    QTRY_VERIFY_WITH_TIMEOUT(controller->evolving(), kPatienceMs);
    controller.reset();
  }
};

QTEST_GUILESS_MAIN(TestController)
#include "tst_controller.moc"

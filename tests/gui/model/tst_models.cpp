// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <thread>

#include "gui/model/case_models.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/gui/small_case.h"

using namespace angiomesh;
using angiomesh::test::evolveFor;
using angiomesh::test::kLongEvolution;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;

namespace {

constexpr int kPatienceMs = 60000;

/// The messages of the models, by severity.
struct Messages {
  explicit Messages(CaseModels& models) {
    QObject::connect(&models.log, &MessageLog::message, &models.log,
                     [this](Severity severity, const QString& text) {
                       (severity == Severity::Error ? errors : others) << text;
                     });
  }
  QStringList errors, others;
};

}  // namespace

class TestModels : public QObject {
  Q_OBJECT

 private:
  static void verifyStates(const CaseModels& models, Step firstStale, StepState after) {
    for (int i = static_cast<int>(Step::Preprocess); i < kStepCount; ++i) {
      const Step step = static_cast<Step>(i);
      QVERIFY2(models.runs.state(step) == (step < firstStale ? StepState::Fresh : after),
               stepId(step));
    }
  }

 private Q_SLOTS:
  void runsAllSteps() {
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.files.take(twoTubes());
    QVERIFY(models.document.hasCase());
    QVERIFY(models.runs.state(Step::Vesselness) == StepState::Empty);
    models.runs.run();
    QVERIFY2(messages.errors.isEmpty(), qPrintable(messages.errors.join('\n')));
    verifyStates(models, static_cast<Step>(kStepCount), StepState::Stale);
    QCOMPARE(models.results.components().size(), std::size_t(2));
    QVERIFY(models.results.quality(MeshKind::Exported)->closed);
    QVERIFY(models.results.layer(Layer::Speed) != nullptr);
    QVERIFY(models.results.seconds(Step::Vesselness) > 0.0);
  }

  void runsUpToAStep() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.runs.run(Step::Vesselness);
    verifyStates(models, Step::Seeds, StepState::Empty);
  }

  void notesAreEditsThatComputeNothingAnew() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.runs.run();
    CaseDocument& document = models.document;
    QUndoStack& undo = *document.undoStack();
    const std::string key = document.key(Step::Evolve);
    const QSignalSpy noted(&document, &CaseDocument::notesChanged);
    const QSignalSpy edited(&document, &CaseDocument::edited);
    CaseNotes one;
    one.measurements.emplace_back();
    one.measurements.back().name = "Distance 1";
    document.changeNotes(one, "measure a distance");
    QCOMPARE(undo.undoText(), QString("measure a distance"));
    QVERIFY(document.notes() == one);
    QVERIFY(document.modified());
    document.changeNotes(one, "the same");
    QCOMPARE(undo.count(), 1);
    QCOMPARE(noted.size(), 1);
    QCOMPARE(edited.size(), 0);
    QCOMPARE(document.key(Step::Evolve), key);
    verifyStates(models, static_cast<Step>(kStepCount), StepState::Stale);
    QVERIFY(models.results.meshFresh());

    // In between parameters: each undo takes back its own edit.
    document.setField("levelset.xi", 35.0);
    QVERIFY(document.notes() == one);
    CaseNotes two = one;
    two.measurements.back().name = "Neck";
    document.changeNotes(two, "rename");
    undo.undo();
    QVERIFY(document.notes() == one);
    QCOMPARE(document.parameters().thresholds.xi, 35.0);
    undo.undo();
    QVERIFY(document.notes() == one);
    QVERIFY(document.parameters().thresholds.xi != 35.0);
    QCOMPARE(noted.size(), 3);
    undo.undo();
    QVERIFY(document.notes() == CaseNotes());
    undo.setIndex(undo.count());
    QVERIFY(document.notes() == two);
    QCOMPARE(document.parameters().thresholds.xi, 35.0);
    models.files.take(twoTubes());
    QVERIFY(document.notes() == CaseNotes());
  }

  void notesAreSavedWithTheCase() {
    const QTemporaryDir folder;
    const QString saved = folder.filePath("a.angiomesh");
    CaseNotes notes;
    notes.measurements.emplace_back();
    notes.measurements.back().name = "Distance 1";
    notes.measurements.back().places = {{1, 2, 3}, {4, 5, 6}};
    {
      CaseModels models(makeInlineJobRunner);
      models.files.openSample();
      models.files.saveCase(saved, {});
      QVERIFY(!models.document.modified());
      models.document.changeNotes(notes, "measure a distance");
      QVERIFY(models.document.modified());
      models.files.saveCase(saved, {});
      QVERIFY(!models.document.modified());
    }
    for (const bool crash : {false, true}) {
      CaseModels models(makeInlineJobRunner);
      const QSignalSpy noted(&models.document, &CaseDocument::notesChanged);
      models.files.openCase({saved.toStdString(), nullptr, {}, {}, crash});
      QCOMPARE(models.document.notes().measurements.size(), std::size_t(1));
      QVERIFY(noted.size() > 0);
      if (crash) break;
      QVERIFY(models.document.notes() == notes);
      QVERIFY(!models.document.modified());
      // A program that ends without a word leaves its journal.
      CaseNotes renamed = notes;
      renamed.measurements.back().name = "Neck";
      models.document.changeNotes(renamed, "rename");
    }
    CaseModels models(makeInlineJobRunner);
    models.files.openCase({saved.toStdString(), nullptr, {}, {}, true});
    QCOMPARE(models.document.notes().measurements.front().name, std::string("Neck"));
    QCOMPARE(models.document.undoStack()->undoText(), QString("rename"));
    models.document.undoStack()->undo();
    QVERIFY(models.document.notes() == notes);
  }

  void changesReachTheStepsThatDependOnThemOnly() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.runs.run();
    models.document.setField("levelset.xi", 35.0);
    verifyStates(models, Step::Evolve, StepState::Stale);
    models.document.undoStack()->undo();
    verifyStates(models, static_cast<Step>(kStepCount), StepState::Stale);
    models.document.undoStack()->redo();
    models.runs.run();
    const auto after = models.results.mesh(MeshKind::Exported);
    models.document.undoStack()->undo();
    verifyStates(models, static_cast<Step>(kStepCount), StepState::Stale);
    QVERIFY(models.results.mesh(MeshKind::Exported) != after);
    models.document.undoStack()->redo();
    QVERIFY(models.results.mesh(MeshKind::Exported) == after);
  }

  void aDragIsOneEdit() {
    CaseModels models(makeInlineJobRunner);
    models.document.setField("levelset.gamma", 0.5, false);
    models.document.setField("levelset.gamma", 0.4, true);
    models.document.setField("levelset.gamma", 0.3, true);
    models.document.setField("levelset.gamma", 0.2, false);
    QCOMPARE(models.document.undoStack()->count(), 2);
    models.document.undoStack()->undo();
    QCOMPARE(models.document.parameters().levelset.gamma, 0.3);
    models.document.undoStack()->undo();
    QCOMPARE(models.document.parameters().levelset.gamma, 0.7);
  }

  void theLastEditsAreKept() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    constexpr int kMore = 10;
    const auto xiAfter = [](int edits) { return 20.0 + 0.01 * edits; };
    for (int n = 1; n <= CaseDocument::kMostEdits + kMore; ++n)
      models.document.setField("levelset.xi", xiAfter(n));
    QUndoStack& undo = *models.document.undoStack();
    QCOMPARE(undo.count(), CaseDocument::kMostEdits);
    while (undo.canUndo()) undo.undo();
    QCOMPARE(models.document.parameters().thresholds.xi, xiAfter(kMore));
    QVERIFY(models.document.modified());
    while (undo.canRedo()) undo.redo();
    QCOMPARE(models.document.parameters().thresholds.xi, xiAfter(CaseDocument::kMostEdits + kMore));
  }

  void valuesOutOfRangeAreRefused() {
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.document.setField("levelset.gamma", 7.0);
    QCOMPARE(messages.errors.size(), 1);
    QVERIFY(messages.errors.first().contains("levelset.gamma"));
    QCOMPARE(models.document.parameters().levelset.gamma, 0.7);
    QCOMPARE(models.document.undoStack()->count(), 0);
  }

  void boundsPushEachOther() {
    CaseModels models(makeInlineJobRunner);
    models.document.setField("vesselness.sigmaMinMm", 1.0);
    models.document.setField("vesselness.sigmaMaxMm", 3.0);
    models.document.setField("vesselness.sigmaMinMm", 4.0);
    QCOMPARE(*models.document.parameters().vesselness.sigmaMaxMm, 4.0);
  }

  void aFailureNamesItsStep() {
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.files.take(twoTubes());
    models.document.setField("levelset.b", 1.0);
    models.runs.run();
    QVERIFY(models.runs.state(Step::Evolve) == StepState::Failed);
    QVERIFY(models.runs.state(Step::Seeds) == StepState::Fresh);
    QVERIFY(!models.runs.failure(Step::Evolve).isEmpty());
    QCOMPARE(messages.errors.size(), 1);
    models.document.setField("levelset.b", 0.1);
    QVERIFY(models.runs.state(Step::Evolve) == StepState::Empty);
    QVERIFY(models.runs.failure(Step::Evolve).isEmpty());
  }

  /// A surface that is not begun costs nothing of what was computed before it.
  void aRefusedSurfaceKeepsTheEvolution() {
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.files.take(twoTubes());
    models.document.setField("surface.maxTriangles", std::int64_t(100));
    models.runs.run();
    QVERIFY(models.runs.state(Step::Surface) == StepState::Failed);
    QVERIFY(models.runs.state(Step::Evolve) == StepState::Fresh);
    const QString why = models.runs.failure(Step::Surface);
    QVERIFY2(why.contains("surface.edgeMinMm") && why.contains("surface.maxTriangles"),
             qPrintable(why));
    QCOMPARE(models.results.expectationWarnings().size(), 1);
    models.document.setField("surface.maxTriangles", std::int64_t(0));
    QVERIFY(models.results.expectationWarnings().isEmpty());
    models.runs.run();
    QVERIFY(models.runs.state(Step::Quality) == StepState::Fresh);
  }

  void aRunWithoutSeedsSaysSo() {
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.files.take(twoTubes());
    models.document.setField("seeds.automatic", false);
    QVERIFY(messages.errors.isEmpty());
    models.runs.run();
    QVERIFY(models.runs.state(Step::Seeds) == StepState::Failed);
    QCOMPARE(messages.errors.size(), 1);
    const auto along = models.document.image()->geometry.toPhysical({20.0, 20.0, 20.0});
    models.document.addSeed(along);
    QVERIFY(models.runs.state(Step::Seeds) == StepState::Empty);
  }

  void seedsGoAndComeBack() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.document.addSeed({1.0, 2.0, 3.0});
    models.document.addSeed({4.0, 5.0, 6.0});
    models.document.removeSeed(0);
    QCOMPARE(models.document.seeds().size(), std::size_t(1));
    QCOMPARE(models.document.seeds().front(), Eigen::Vector3d(4.0, 5.0, 6.0));
    models.document.undoStack()->undo();
    QCOMPARE(models.document.seeds().size(), std::size_t(2));
    models.document.removeSeed(9);
    QCOMPARE(models.document.seeds().size(), std::size_t(2));
  }

  void aRegionOutsideTheImageIsRefused() {
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.files.take(twoTubes());
    models.document.setRoi(std::array<double, 6>{500, 500, 500, 600, 600, 600});
    QCOMPARE(messages.errors.size(), 1);
    QVERIFY(!models.document.parameters().preprocess.roi);
    models.document.setRoi(std::array<double, 6>{0, 0, 0, 20, 20, 8});
    models.runs.run(Step::Preprocess);
    QVERIFY(models.results.layer(Layer::Preprocessed)->geometry.size[2] < 20);
  }

  void partsAreTickedOffAndOn() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.runs.run();
    const std::size_t both = models.results.mesh(MeshKind::Exported)->triangles.size();
    models.results.setComponentTicked(1, false);
    verifyStates(models, Step::Surface, StepState::Stale);
    QVERIFY(!models.results.components()[1].ticked);
    models.runs.run();
    QVERIFY(models.results.mesh(MeshKind::Exported)->triangles.size() < both);
    QCOMPARE(models.results.components().size(), std::size_t(2));
    QVERIFY(!models.results.components()[1].ticked);
    QVERIFY(!models.results.components()[1].byRule);
    models.results.setComponentTicked(1, true);
    QVERIFY(models.results.components()[1].ticked);
    QVERIFY(models.results.meshFresh());
    QCOMPARE(models.results.mesh(MeshKind::Exported)->triangles.size(), both);
  }

  void aPartLeftOutByRuleHasNoTick() {
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.document.setField("segmentation.keep", std::string("largest"));
    models.runs.run();
    QVERIFY(models.results.components()[0].ticked);
    QVERIFY(models.results.components()[1].byRule);
    QVERIFY(!models.results.components()[1].ticked);
  }

  void badFilesLeaveTheCaseAlone() {
    const QTemporaryDir folder;
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.files.take(twoTubes());
    const QString path = folder.filePath("Doe_John.mha");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is not an image");
    file.close();
    models.files.open(path);
    models.files.open(folder.filePath("missing.nii.gz"));
    models.files.open(folder.path());
    QCOMPARE(messages.errors.size(), 3);
    for (const QString& error : messages.errors) {
      QVERIFY2(!error.contains(folder.path()), qPrintable(error));
    }
    QCOMPARE(models.document.caseName(), QString("two-tubes"));
  }

  void anotherCaseBeginsAnew() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scan.nii.gz");
    writeVolume(*twoTubes().image, path.toStdString());
    CaseModels models(makeInlineJobRunner);
    models.files.take(twoTubes());
    models.document.setField("levelset.xi", 33.0);
    models.document.addSeed({1.0, 2.0, 3.0});
    models.runs.run(Step::Preprocess);
    QSignalSpy opened(&models.files, &CaseFiles::opened);
    models.files.open(path);
    QCOMPARE(opened.size(), 1);
    QCOMPARE(models.document.caseName(), QString("scan"));
    QVERIFY(models.document.parameters() == preset("angiomesh"));
    QVERIFY(models.runs.state(Step::Preprocess) == StepState::Empty);
    QCOMPARE(models.document.undoStack()->count(), 0);
  }

  void exportsMeshAndReport() {
    const QTemporaryDir folder;
    CaseModels models(makeInlineJobRunner);
    Messages messages(models);
    models.exports.exportMesh(MeshKind::Exported, folder.filePath("none.ply"), {}, {});
    QCOMPARE(messages.errors.size(), 1);
    models.files.take(twoTubes());
    models.runs.run();
    models.exports.exportMesh(MeshKind::Exported, folder.filePath("a.ply"), {}, {.report = true});
    QVERIFY(QFile::exists(folder.filePath("a.report.json")));
    const TriMesh back = readMesh(folder.filePath("a.ply").toStdString());
    QCOMPARE(back.triangles.size(), models.results.mesh(MeshKind::Exported)->triangles.size());
    const QString triangles = QString("%1 triangles, closed").arg(back.triangles.size());
    QVERIFY2(messages.others.last().contains(triangles), qPrintable(messages.others.last()));
    models.exports.exportMesh(MeshKind::Exported, folder.filePath("no/such/a.stl"), {}, {});
    QCOMPARE(messages.errors.size(), 2);
    QVERIFY(!messages.errors.last().contains(folder.path()));
  }

  void theEvolutionIsWatched() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    evolveFor(models);
    QSignalSpy snapshots(&models.runs, &RunModel::snapshotArrived);
    models.runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(snapshots.size() > 2, kPatienceMs);
    QVERIFY(models.runs.evolving());
    QVERIFY(models.results.liveSurface() && !models.results.liveSurface()->triangles.empty());
    QVERIFY(models.runs.state(Step::Evolve) == StepState::Running);
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.history().size() > 2, kPatienceMs);

    models.runs.setPaused(true);
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.paused(), kPatienceMs);
    int before = -1;
    // The worker ends the chunk in hand before it pauses.
    QTRY_VERIFY_WITH_TIMEOUT(
        std::exchange(before, models.runs.iterations()) == models.runs.iterations(), kPatienceMs);
    models.runs.stepEvolution(7);
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.iterations() >= before + 7, kPatienceMs);

    models.runs.finishEvolution();
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QVERIFY(models.runs.state(Step::Quality) == StepState::Fresh);
    QVERIFY(models.results.evolveResult()->stopReason == StopReason::Stopped);
    QVERIFY(models.results.evolveResult()->iterations > 0);
    QVERIFY(!models.results.liveSurface());
  }

  void aChangeInMidRunRestarts() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    evolveFor(models);
    models.runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.evolving() && models.runs.iterations() > 0, kPatienceMs);
    const auto vesselness = models.results.vesselnessResult();
    models.document.setField("levelset.maxIterations", std::int64_t(40));
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QVERIFY(models.runs.state(Step::Quality) == StepState::Fresh);
    QCOMPARE(models.results.evolveResult()->iterations, 40);
    QVERIFY(models.results.vesselnessResult() == vesselness);
  }

  void aChangeBehindTheStepInWorkLetsItGoOn() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    evolveFor(models, kLongEvolution);
    models.runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.evolving() && models.runs.iterations() > 0, kPatienceMs);
    int most = models.runs.iterations();
    bool fellBack = false;
    connect(&models.timer, &JobTimer::ticked, this, [&] {
      fellBack = fellBack || models.runs.iterations() < most;
      most = models.runs.iterations();
    });
    models.document.setField("smooth.iterations", std::int64_t(3));
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QVERIFY(!fellBack);
    QVERIFY(models.runs.state(Step::Quality) == StepState::Fresh);
  }

  void cancelActsSoonAndLeavesTheProgramUsable() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    evolveFor(models);
    models.runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.evolving(), kPatienceMs);
    models.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), 2000);
    QVERIFY(models.runs.state(Step::Evolve) == StepState::Empty);
    QVERIFY(models.runs.state(Step::Seeds) == StepState::Fresh);
    QVERIFY(!models.results.liveSurface());
    models.document.setField("levelset.maxIterations", std::int64_t(20));
    models.runs.run(Step::Evolve);
    QTRY_VERIFY_WITH_TIMEOUT(!models.runs.running(), kPatienceMs);
    QVERIFY(models.runs.state(Step::Evolve) == StepState::Fresh);
  }

  void aCaseOpenedInMidRunTakesOver() {
    CaseModels models;
    models.files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.hasCase(), kPatienceMs);
    evolveFor(models);
    models.runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(models.runs.evolving(), kPatienceMs);
    models.files.take(twoTubes());
    QTRY_COMPARE_WITH_TIMEOUT(models.document.caseName(), QString("two-tubes"), kPatienceMs);
    QVERIFY(!models.runs.running());
    QVERIFY(models.runs.state(Step::Vesselness) == StepState::Empty);
    QVERIFY(!models.results.phi());
  }

  void aJobThatStartsWhileOthersAreLookedAtIsLookedAtToo() {
    struct Job {
      void execute() noexcept { std::this_thread::sleep_for(std::chrono::milliseconds(50)); }
    };
    JobTimer timer;
    bool done = false;
    JobSlot<Job> first(timer, makeThreadedJobRunner, [&](const auto&) { done = true; });
    JobSlot<Job> second(timer, makeThreadedJobRunner,
                        [&](const auto&) { first.start(std::make_shared<Job>()); });
    second.start(std::make_shared<Job>());
    QTRY_VERIFY_WITH_TIMEOUT(done, kPatienceMs);
  }

  void goesWhileRunning() {
    auto models = std::make_unique<CaseModels>();
    models->files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(models->document.hasCase(), kPatienceMs);
    evolveFor(*models);
    models->runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(models->runs.evolving(), kPatienceMs);
    models.reset();
  }
};

QTEST_GUILESS_MAIN(TestModels)
#include "tst_models.moc"

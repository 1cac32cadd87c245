// SPDX-License-Identifier: BSD-3-Clause
#include <QDirIterator>
#include <QFile>
#include <QPlainTextEdit>
#include <QSignalSpy>

#include "io/case/case_file.h"
#include "io/case/case_journal.h"
#include "study_case.h"

using namespace angiomesh;
using angiomesh::test::action;
using angiomesh::test::kPatienceMs;
using angiomesh::test::kPatient;
using angiomesh::test::makeCase;
using angiomesh::test::Study;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

void verifyNoName(const QString& folder) {
  QDirIterator files(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  int count = 0;
  while (files.hasNext()) {
    QFile file(files.next());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY2(!bytes.contains(kPatient) && !bytes.contains("scans") && !bytes.contains(".mha"),
             qPrintable(file.fileName()));
    ++count;
  }
  QVERIFY(count > 0);
}

}  // namespace

class TestCase : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aCaseIsSavedAndOpened() {
    const Study study;
    Eigen::Vector3d crosshair;
    {
      WindowCase c;
      makeCase(c, study);
      QCOMPARE(c.answers.asked, QStringList{"saveCaseAs vessels.angiomesh"});
      QCOMPARE(c.window->windowTitle(), QString("vessels[*] — Angiomesh"));
      QVERIFY(!c.window->isWindowModified());
      c.models().runs.run(Step::Vesselness);
      c.state().setWindowLevel(123.0, 45.0);
      c.state().setLayer(Layer::Vesselness);
      c.state().setWindowLevel(0.25, 0.125);
      c.state().setSlab(1, {SlabMode::MinIp, 4.5});
      c.state().setVolumeView(VolumeView::None);
      crosshair = c.models().document.image()->geometry.toPhysical({10.0, 12.0, 14.0});
      c.window->views().setCrosshair(crosshair);
      action(c, "saveCase")->trigger();
      QCOMPARE(c.answers.asked.size(), 1);
      QVERIFY(c.window->close());
      QCOMPARE(c.answers.asked.size(), 1);
    }
    QCOMPARE(QSettings().value("recent").toStringList().first(), study.saved);
    WindowCase c;
    c.openPath = study.saved;
    action(c, "openFolder")->trigger();
    QCOMPARE(c.window->windowTitle(), QString("vessels[*] — Angiomesh"));
    QCOMPARE(c.models().document.parameters().thresholds.xi, 31.0);
    QCOMPARE(c.models().document.seeds().size(), std::size_t(1));
    QVERIFY(!c.models().document.modified());
    QCOMPARE(c.models().document.undoStack()->count(), 0);
    QVERIFY(c.state().layer() == Layer::Source);
    QCOMPARE(c.state().windowLevel(), std::pair(123.0, 45.0));
    QVERIFY((c.state().slab(1) == Slab{SlabMode::MinIp, 4.5}));
    QVERIFY(c.state().slab(0) == Slab());
    QVERIFY(c.state().volumeView() == VolumeView::None);
    QVERIFY((c.window->views().slice(0)->cursor() - crosshair).norm() < 1e-6);
    // The layer that was shown comes back once it is computed.
    c.models().runs.run(Step::Vesselness);
    QVERIFY(c.state().layer() == Layer::Vesselness);
    QCOMPARE(c.state().windowLevel(), std::pair(0.25, 0.125));
    c.window->open(study.saved + "/case.json");
    QVERIFY(c.find<QPlainTextEdit>("log")->toPlainText().contains("open already"));
  }

  void theResultOfASavedCaseIsShownAtOnce() {
    const Study study;
    std::shared_ptr<const TriMesh> mesh;
    {
      WindowCase c;
      makeCase(c, study);
      c.models().runs.run();
      mesh = c.models().results.mesh(MeshKind::Exported);
      QVERIFY(c.window->close());
    }
    verifyNoName(study.saved);
    for (const bool threaded : {true, false}) {
      WindowCase c(threaded ? makeThreadedJobRunner : makeInlineJobRunner);
      c.window->open(study.saved);
      QTRY_VERIFY_WITH_TIMEOUT(c.models().results.phi() != nullptr, kPatienceMs);
      QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), kPatienceMs);
      QVERIFY(c.models().runs.state(Step::Evolve) == StepState::Fresh);
      QVERIFY(c.models().runs.state(Step::Vesselness) == StepState::Empty);
      c.models().runs.run();
      QTRY_VERIFY_WITH_TIMEOUT(c.models().results.meshFresh(), kPatienceMs);
      QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), kPatienceMs);
      QVERIFY(c.models().runs.state(Step::Vesselness) == StepState::Empty);
      QVERIFY(c.models().results.mesh(MeshKind::Exported)->points == mesh->points);
      c.models().runs.run(Step::Vesselness);
      QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.state(Step::Vesselness) == StepState::Fresh,
                               kPatienceMs);
      QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), kPatienceMs);
      c.models().document.setField("vesselness.sigmaMinMm", 0.75);
      QVERIFY(c.models().runs.state(Step::Evolve) == StepState::Stale);
      c.models().document.undoStack()->undo();
      QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.state(Step::Evolve) == StepState::Fresh,
                               kPatienceMs);
    }
    QVERIFY(QDir(study.saved + "/cache").removeRecursively());
    WindowCase c;
    c.window->open(study.saved);
    QCOMPARE(c.models().document.caseName(), QString("vessels"));
    QVERIFY(!c.models().results.phi());
  }

  void theTitleMarksUnsavedChanges() {
    const Study study;
    WindowCase c;
    c.models().document.setField("levelset.xi", 30.0);
    QVERIFY(!c.window->isWindowModified());
    makeCase(c, study);
    c.models().document.setField("levelset.xi", 32.0);
    QVERIFY(c.window->isWindowModified());
    c.clickTool("undo");
    QVERIFY(!c.window->isWindowModified());
    c.clickTool("undo");
    QVERIFY(c.window->isWindowModified());
    c.clickTool("saveCase");
    QVERIFY(!c.window->isWindowModified());
    QVERIFY(readCase(study.saved.toStdString()).document.params.seeds.points.empty());
  }

  void aNewNameIsAskedBeforeAnotherCaseIsReplaced() {
    const Study study;
    {
      WindowCase c;
      makeCase(c, study);
    }
    WindowCase c;
    c.window->open(study.volume);
    c.models().document.setField("levelset.xi", 12.0);
    c.answers.savePath = study.folder.filePath("cases/vessels");
    action(c, "saveCaseAs")->trigger();
    QCOMPARE(c.answers.asked.last(), QString("replace vessels"));
    QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 31.0);
    c.answers.replace = true;
    c.answers.savePath = study.saved + "/vessels.angiomesh";
    action(c, "saveCaseAs")->trigger();
    QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 12.0);
    QCOMPARE(c.models().files.caseFolder(), study.saved);
    c.answers.savePath = study.folder.filePath("no/such/place");
    action(c, "saveCaseAs")->trigger();
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QVERIFY2(log.contains("Cannot save the case") && !log.contains(study.folder.path()),
             qPrintable(log));
    QCOMPARE(c.models().files.caseFolder(), study.saved);
  }

  void noFileTellsWhereTheVolumeLay() {
    const Study study;
    WindowCase c(makeInlineJobRunner, study.recovery);
    c.window->open(study.volume);
    c.models().document.setField("levelset.xi", 30.0);
    QCOMPARE(study.recoveries(), 1);
    verifyNoName(QString::fromStdString(study.recovery.string()));
    makeCase(c, study);
    QCOMPARE(study.recoveries(), 0);
    c.models().document.setField("levelset.xi", 33.0);
    QCOMPARE(readJournal(study.saved.toStdString(), 0).size(), std::size_t(1));
    verifyNoName(study.saved);
    QVERIFY(!c.find<QPlainTextEdit>("log")->toPlainText().contains("scans"));
  }

  void aMovedVolumeIsFoundByItsContent() {
    const Study study;
    {
      WindowCase c;
      makeCase(c, study);
    }
    // Renamed, beside the case.
    const QString beside = study.folder.filePath("cases/renamed.mha");
    QVERIFY(QFile::rename(study.volume, beside));
    {
      WindowCase c;
      c.window->open(study.saved);
      QCOMPARE(c.models().document.caseName(), QString("vessels"));
      QVERIFY(c.answers.asked.isEmpty());
    }
    // The case moved away, as to another disk: the settings know where the volume was.
    const QTemporaryDir elsewhere;
    const QString moved = elsewhere.filePath("disk/mine.angiomesh");
    QVERIFY(QDir(elsewhere.path()).mkdir("disk"));
    QVERIFY(QFile::rename(study.saved, moved));
    {
      WindowCase c;
      c.window->open(moved);
      QCOMPARE(c.models().document.caseName(), QString("mine"));
    }
    // Both.
    const QString far = study.folder.filePath(QString(kPatient) + "/far.mha");
    QVERIFY(QFile::rename(beside, far));
    WindowCase c;
    c.openPath = study.otherVolume();
    c.window->open(moved);
    QTRY_VERIFY(!c.answers.asked.isEmpty());
    QVERIFY2(c.answers.asked.first().contains("40 × 40 × 40 voxels"),
             qPrintable(c.answers.asked.first()));
    QVERIFY(!c.models().document.hasCase());
    c.answers.source = {SourceAnswer::File, SourceAnswer::Cancel};
    c.window->open(moved);
    QTRY_COMPARE(c.answers.asked.size(), 3);
    QVERIFY2(c.answers.asked.last().contains("not the volume"), qPrintable(c.answers.asked.last()));
    QVERIFY(!c.models().document.hasCase());
    c.openPath = far;
    c.answers.source = {SourceAnswer::File};
    c.window->open(moved);
    QTRY_COMPARE(c.models().document.caseName(), QString("mine"));
    QCOMPARE(c.models().document.parameters().thresholds.xi, 31.0);
    QVERIFY(QSettings().value("sources").toStringList().first().endsWith("far.mha"));
  }

  void anotherVolumeTakesTheParametersAlone() {
    const Study study;
    {
      WindowCase c;
      makeCase(c, study);
    }
    QVERIFY(QFile::remove(study.volume));
    WindowCase c;
    c.openPath = study.otherVolume();
    c.answers.source = {SourceAnswer::File, SourceAnswer::ParametersOnly};
    c.window->open(study.saved);
    QTRY_VERIFY(c.models().document.hasCase());
    QCOMPARE(c.models().document.parameters().thresholds.xi, 31.0);
    QVERIFY(c.models().document.seeds().empty());
    QVERIFY(c.models().files.caseFolder().isEmpty());
    QCOMPARE(c.models().document.image()->voxels[5], twoTubes().image->voxels[5] + 1.0F);
  }

  void theSampleNeedsNoFile() {
    const Study study;
    {
      WindowCase c;
      c.window->openSample();
      c.answers.savePath = study.saved;
      action(c, "saveCase")->trigger();
    }
    WindowCase c;
    c.window->open(study.saved);
    QCOMPARE(c.models().document.caseName(), QString("vessels"));
    QVERIFY(c.answers.asked.isEmpty());
  }

  void aMissingVolumeLeavesTheRunAlone() {
    const Study study;
    {
      WindowCase c;
      makeCase(c, study);
    }
    QVERIFY(QFile::remove(study.volume));
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(test::slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    test::evolveFor(c.models());
    c.models().runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.evolving(), kPatienceMs);
    c.answers.save = SaveAnswer::Discard;
    c.window->open(study.saved);
    QTRY_VERIFY_WITH_TIMEOUT(c.answers.asked.size() == 2, kPatienceMs);
    QVERIFY(c.models().runs.running());
    QCOMPARE(c.models().document.caseName(), QString("tree"));
  }

  void closingAsksAboutUnsavedChanges() {
    const Study study;
    WindowCase c;
    makeCase(c, study);
    c.models().document.setField("levelset.xi", 38.0);
    c.answers.save = SaveAnswer::Cancel;
    QVERIFY(!c.window->close());
    QCOMPARE(c.answers.asked.last(), QString("saveChanges vessels"));
    c.window->openSample();
    QCOMPARE(c.models().document.caseName(), QString("vessels"));
    c.answers.save = SaveAnswer::Save;
    c.window->close();
    QTRY_VERIFY(!c.window->isVisible());
    QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 38.0);
  }

  void discardedChangesLeaveTheLastSave() {
    const Study study;
    WindowCase c;
    makeCase(c, study);
    c.models().document.setField("levelset.xi", 38.0);
    c.answers.save = SaveAnswer::Discard;
    QVERIFY(c.window->close());
    QTRY_VERIFY(readJournal(study.saved.toStdString(), 0).empty());
    QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 31.0);
  }

  void anotherVolumeComesAfterTheSave() {
    const Study study;
    WindowCase c;
    makeCase(c, study);
    c.models().document.setField("levelset.xi", 38.0);
    c.answers.save = SaveAnswer::Save;
    c.window->open(study.otherVolume());
    QTRY_COMPARE(c.models().document.caseName(), QString("other"));
    QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 38.0);
    QVERIFY(c.models().files.caseFolder().isEmpty());
  }

  void aCaseThatIsOpenElsewhereIsNotWritten() {
    const Study study;
    WindowCase first;
    makeCase(first, study);
    WindowCase second;
    second.window->open(study.saved);
    QCOMPARE(second.models().document.caseName(), QString("vessels"));
    QVERIFY(second.models().files.caseFolder().isEmpty());
    QVERIFY(second.find<QPlainTextEdit>("log")->toPlainText().contains("another window"));
    second.models().document.setField("levelset.xi", 39.0);
    second.answers.savePath = study.saved;
    second.answers.replace = true;
    action(second, "saveCase")->trigger();
    QVERIFY(second.window->isWindowModified());
    QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 31.0);
  }

  void workersSaveAndNote() {
    const Study study;
    {
      WindowCase c(makeThreadedJobRunner, study.recovery);
      c.window->open(study.volume);
      QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
      for (int i = 0; i < 40; ++i) {
        c.models().document.setField("levelset.xi", 30.0 + i, i > 0);
      }
      QTRY_COMPARE_WITH_TIMEOUT(study.recoveries(), 1, kPatienceMs);
      QSignalSpy saved(&c.models().files, &CaseFiles::caseSaved);
      c.answers.savePath = study.saved;
      action(c, "saveCase")->trigger();
      c.models().document.setField("levelset.xi", 90.0);
      QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatienceMs);
      QVERIFY(c.window->isWindowModified());
      QTRY_VERIFY_WITH_TIMEOUT(!c.models().busy(), kPatienceMs);
      QCOMPARE(study.recoveries(), 0);
    }
    const CaseReading reading = readCase(study.saved.toStdString());
    QCOMPARE(reading.document.params.thresholds.xi, 69.0);
    const auto steps = readJournal(study.saved.toStdString(), reading.document.saves);
    QCOMPARE(steps.size(), std::size_t(1));
    QCOMPARE(steps.front().params.thresholds.xi, 90.0);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestCase>(argc, argv); }
#include "tst_case.moc"

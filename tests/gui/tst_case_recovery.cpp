// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QPlainTextEdit>
#include <QProcess>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "io/case/case_file.h"
#include "io/case/case_journal.h"
#include "study_case.h"

using namespace angiomesh;
using angiomesh::test::action;
using angiomesh::test::kPatienceMs;
using angiomesh::test::makeCase;
using angiomesh::test::Study;
using angiomesh::test::WindowCase;

namespace {

const char* const kEditAndWait = "--edit-and-wait";

/// The child of aKilledWindowLosesNothing(): says when its edit is on the disk, and waits.
int editAndWait(const QString& recovery) {
  CaseModels models(makeInlineJobRunner, recovery.toStdString());
  models.files.openSample();
  models.document.setField("levelset.xi", 34.0);
  std::puts("ready");
  std::fflush(stdout);
  return QCoreApplication::exec();
}

}  // namespace

class TestCaseRecovery : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aCrashLosesNothingOfAnUnsavedCase() {
    const Study study;
    {
      WindowCase c(makeInlineJobRunner, study.recovery);
      c.window->open(study.volume);
      c.models().document.setField("levelset.xi", 30.0);
      c.models().document.setField("levelset.xi", 31.0, true);
      c.models().document.addSeed({1.0, 2.0, 3.0});
      QVERIFY(findRecoveries(study.recovery).empty());  // a running window holds it
    }
    WindowCase c(makeInlineJobRunner, study.recovery);
    QVERIFY(!c.window->offerRestore());
    QCOMPARE(study.recoveries(), 1);
    c.answers.restore = RestoreAnswer::Restore;
    QVERIFY(c.window->offerRestore());
    const QString folder = QFileInfo(study.volume).absoluteDir().dirName();
    const QString name = QFileInfo(study.volume).fileName().section('.', 0, 0);
    QVERIFY2(c.answers.asked.last().startsWith(
                 QString("restoreAtStart 2 changes of %1 (%2)").arg(name, folder)),
             qPrintable(c.answers.asked.last()));
    QCOMPARE(c.models().document.parameters().thresholds.xi, 31.0);
    QCOMPARE(c.models().document.seeds().size(), std::size_t(1));
    QVERIFY(c.window->isWindowModified());
    QCOMPARE(c.models().document.undoStack()->count(), 2);
    c.clickTool("undo");
    QVERIFY(c.models().document.seeds().empty());
    QVERIFY(c.models().files.caseFolder().isEmpty());
    c.answers.save = SaveAnswer::Discard;
    QVERIFY(c.window->close());
    QTRY_COMPARE(study.recoveries(), 0);
  }

  void aLockThatNobodyHoldsDoesNotCount() {
    const Study study;
    {
      WindowCase c;
      makeCase(c, study);
      c.models().document.setField("levelset.xi", 37.0);
    }
    // Nothing, or another machine's.
    for (const QByteArray& text : {QByteArray(), QByteArray("4711\nangiomesh\nelsewhere\n")}) {
      QFile file(study.saved + "/case.lock");
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(text);
      file.close();
      WindowCase c;
      c.answers.restore = RestoreAnswer::Restore;
      c.window->open(study.saved);
      QCOMPARE(c.models().files.caseFolder(), study.saved);
      QTRY_COMPARE(c.models().document.parameters().thresholds.xi, 37.0);
    }
  }

  /// A window that is killed before its first edit is noted, or while it removes its recovery.
  void recoveriesWithoutAnEditGo() {
    const Study study;
    const std::filesystem::path old = study.recovery / "old.angiomesh";
    const std::filesystem::path young = study.recovery / "young.angiomesh";
    for (const std::filesystem::path& folder : {old, young}) {
      std::filesystem::create_directories(folder);
      writeCase(folder, SavedCase());
    }
    std::filesystem::last_write_time(
        old / "case.json", std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    const std::filesystem::path half = study.recovery / "half.angiomesh.removed";
    std::filesystem::create_directories(half / "cache");
    QVERIFY(findRecoveries(study.recovery).empty());
    QVERIFY(!std::filesystem::exists(old));
    QVERIFY(!std::filesystem::exists(half));
    QVERIFY(std::filesystem::exists(young));  // another program may be making it just now
  }

  void aKilledWindowLosesNothing() {
    const Study study;
    QProcess child;
    child.start(QCoreApplication::applicationFilePath(),
                {kEditAndWait, QString::fromStdString(study.recovery.string())});
    QVERIFY(child.waitForReadyRead(kPatienceMs));
    QVERIFY(findRecoveries(study.recovery).empty());
    child.kill();
    QVERIFY(child.waitForFinished(kPatienceMs));
    WindowCase c(makeInlineJobRunner, study.recovery);
    c.answers.restore = RestoreAnswer::Restore;
    QVERIFY(c.window->offerRestore());
    QCOMPARE(c.models().document.parameters().thresholds.xi, 34.0);
    QCOMPARE(c.models().document.image()->geometry.size[0], 128);
  }

  void aCrashLosesNothingOfASavedCase() {
    const Study study;
    for (const bool atStart : {true, false}) {
      {
        WindowCase c;
        makeCase(c, study);
        c.models().document.setField("levelset.xi", 37.0);
      }
      QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 31.0);
      WindowCase c;
      c.answers.restore = RestoreAnswer::Restore;
      if (atStart) {
        QVERIFY(c.window->offerRestore());
      } else {
        c.window->open(study.saved);
      }
      QTRY_COMPARE(c.models().document.parameters().thresholds.xi, 37.0);
      QCOMPARE(c.answers.asked.size(), 1);
      QVERIFY(c.window->isWindowModified());
      action(c, "saveCase")->trigger();
      QCOMPARE(readCase(study.saved.toStdString()).document.params.thresholds.xi, 37.0);
      QVERIFY(readJournal(study.saved.toStdString(), 0).empty());
      QVERIFY(c.window->close());
      QVERIFY(!QFile::exists(study.saved + "/case.lock"));
      WindowCase next;
      QVERIFY(!next.window->offerRestore());
      QVERIFY(QDir(study.saved).removeRecursively());
    }
  }

  void editsThatAreNotWantedGo() {
    const Study study;
    {
      WindowCase c;
      makeCase(c, study);
      c.models().document.setField("levelset.xi", 37.0);
    }
    WindowCase c;
    c.answers.restore = RestoreAnswer::Discard;
    c.window->open(study.saved);
    QTRY_COMPARE(c.answers.asked.size(), 1);
    QCOMPARE(c.models().document.parameters().thresholds.xi, 31.0);
    QTRY_VERIFY(readJournal(study.saved.toStdString(), 0).empty());
  }

  void aJournalThatCannotBeWrittenIsSaidOnce() {
    const Study study;
    QFile file(QString::fromStdString(study.recovery.string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    WindowCase c(makeInlineJobRunner, study.recovery);
    c.window->open(study.volume);
    c.models().document.setField("levelset.xi", 30.0);
    c.models().document.setField("levelset.xi", 33.0);
    auto* log = c.find<QPlainTextEdit>("log");
    QTRY_VERIFY(log->toPlainText().contains("not kept"));
    QTRY_VERIFY(!c.models().busy());
    QCOMPARE(log->toPlainText().count("not kept"), 1);
    QVERIFY(!log->toPlainText().contains(study.folder.path()));
    makeCase(c, study);
    QVERIFY(!c.window->isWindowModified());
  }
};

int main(int argc, char** argv) {
  if (argc > 2 && QLatin1String(argv[1]) == QLatin1String(kEditAndWait)) {
    const QCoreApplication application(argc, argv);
    return editAndWait(QString::fromLocal8Bit(argv[2]));
  }
  return test::runWindowTests<TestCaseRecovery>(argc, argv);
}
#include "tst_case_recovery.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <memory>

#include "gui/dialog/case_questions.h"
#include "gui/dialog/export_dialog.h"
#include "tests/app/cli_process.h"
#include "tests/io/planted_identity.h"
#include "window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

fs::path home, outside;

/// As in a window of the program itself.
fs::path recoveryFolder() { return home / "data/Angiomesh/Angiomesh/recovery"; }

QString text(const fs::path& path) { return QString::fromStdString(path.string()); }

std::unique_ptr<WindowCase> newWindow() {
  return std::make_unique<WindowCase>(makeInlineJobRunner, recoveryFolder());
}

void trigger(WindowCase& c, const char* name) {
  c.window->findChild<QAction*>(QLatin1String(name))->trigger();
}

/// Chooses `path` in the next file dialog, as one does who types it.
void answerFileDialog(const QString& path) {
  QTimer::singleShot(0, qApp, [path] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) {
      answerFileDialog(path);
      return;
    }
    dialog->setDirectory(QFileInfo(path).absolutePath());
    dialog->selectFile(path);
    static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
  });
}

}  // namespace

// The window on inputs that say who it is: no case, recovery, mesh, report or picture may, and only
// the user's own settings know a path.
class TestPrivacyWindow : public QObject {
  Q_OBJECT

 private:
  fs::path planted_, series_, damaged_;
  std::vector<fs::path> volumes_;

  /// Everything in the home except for the settings.
  [[nodiscard]] static std::string told() {
    std::string all;
    for (const auto& entry : fs::directory_iterator(home))
      if (entry.path() != home / "config") all += joined(identityIn(entry.path()));
    return all;
  }
  void verifyLogHasNoPath(WindowCase& c) const {
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QVERIFY(!log.isEmpty());
    QVERIFY2(!log.contains(text(outside)) && !log.contains(kBirthDate) && !log.contains("Study") &&
                 !log.contains(text(home)),
             qPrintable(log));
  }

 private Q_SLOTS:
  void initTestCase() {
    planted_ = outside / "planted";
    const Phantom phantom = plantedTubes();
    series_ = plantedFolder(planted_ / "whole");
    savePlantedSeries(phantom.image, series_);
    damaged_ = plantedFolder(planted_ / "damaged");
    savePlantedSlice(phantom.image, 0, damaged_ / (std::string(kPerson) + ".dcm"));
    volumes_ = savePlantedVolumes(phantom.image, plantedFolder(planted_ / "volumes"));
  }
  void init() {
    QSettings().clear();
    for (const char* name : {"cases", "meshes", "data"}) {
      fs::remove_all(home / name);
      fs::create_directories(home / name);
    }
  }

  void casesAndMeshes() {
    auto c = newWindow();
    c->window->open(text(series_));
    c->models().document.addSeed({1.0, 2.0, 3.0});
    c->models().runs.run();
    QVERIFY(c->models().results.mesh(MeshKind::Exported) != nullptr);
    c->answers.savePath = text(home / "cases/vessels.angiomesh");
    trigger(*c, "saveCase");
    trigger(*c, "saveCase");  // with a previous one
    c->models().document.setField("levelset.xi", 31.0);
    for (const char* name : {"a.ply", "b.stl", "c.obj", "d.vtp"})
      c->models().exports.exportMesh(MeshKind::Exported, text(home / "meshes" / name), {},
                                     {.report = true});
    c->savePath = text(home / "meshes/report.html");
    trigger(*c, "exportReport");
    c->savePath = text(home / "meshes/case.recipe.json");
    trigger(*c, "exportRecipe");
    for (const char* name : {"copyCommandLine", "copyMethods"}) {
      trigger(*c, name);
      save(home / "meshes" / name, QGuiApplication::clipboard()->text().toStdString());
    }
    verifyLogHasNoPath(*c);
    // The window goes as in a crash: lock and journal stay.
    c.reset();
    for (const char* name : {"case.json", "case.previous.json", "edits/journal.jsonl", "cache"})
      QVERIFY2(fs::exists(home / "cases/vessels.angiomesh" / name), name);
    QCOMPARE(filesBelow(home / "meshes"), std::size_t{12});
    QVERIFY2(told().empty(), told().c_str());
  }

  /// A DICOM segmentation refers to the scan by its UIDs, and names the patient on request alone.
  void aMaskForViewers() {
    auto c = newWindow();
    c->window->open(text(series_));
    c->models().runs.run(Step::Evolve);
    const auto exported = [&](const char* name, bool withIdentity) {
      const fs::path path = home / "meshes" / name;
      c->savePath = text(path);
      trigger(*c, "export");
      auto* dialog = c->find<QDialog>("exportDialog");
      if (!dialog || !QTest::qWaitFor([&] { return dialog->isVisible(); })) return fs::path();
      auto* identity = dialog->findChild<QCheckBox*>("exportIdentity");
      auto* format = dialog->findChild<QComboBox*>("exportFormat");
      if (identity->isVisible() || identity->isChecked()) return fs::path();
      c->choose(format, format->count() - 1);
      if (!identity->isVisible() || identity->isChecked()) return fs::path();
      if (withIdentity) QTest::mouseClick(identity, Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
      c->click(dialog->findChild<QPushButton*>("exportGo"));
      return QTest::qWaitFor([&] { return !c->find<QDialog>("exportDialog"); }) ? path : fs::path();
    };
    const std::vector<std::string> person{kPerson, kBirthDate, kStudyDate};
    const std::string none = bytesOf(exported("none.dcm", false));
    QVERIFY(none.find(kUidRoot) != std::string::npos);
    QVERIFY2(foundIn(none, person).empty(), joined(foundIn(none, person)).c_str());
    QCOMPARE(foundIn(bytesOf(exported("of.dcm", true)), person).size(), person.size());
    verifyLogHasNoPath(*c);
    QVERIFY(c->find<QPlainTextEdit>("log")->toPlainText().contains("Wrote none.dcm"));
    // The scan is gone: the message has no path of it.
    const fs::path away = planted_ / "away";
    fs::rename(series_, away);
    (void)exported("gone.dcm", false);
    fs::rename(away, series_);
    QVERIFY(c->find<QPlainTextEdit>("log")->toPlainText().contains("Cannot export"));
    verifyLogHasNoPath(*c);
  }

  void edits() {
    for (const fs::path& path : {series_, volumes_[0], volumes_[1], volumes_[5]}) {
      auto c = newWindow();
      c->window->open(text(path));
      c->models().document.setField("levelset.xi", 31.0);
      c->models().document.addSeed({1.0, 2.0, 3.0});
      verifyLogHasNoPath(*c);
    }
    QVERIFY(filesBelow(recoveryFolder()) >= 8);
    QVERIFY2(told().empty(), told().c_str());
    auto c = newWindow();
    c->answers.restore = RestoreAnswer::Restore;
    QVERIFY(c->window->offerRestore());
    QVERIFY(c->models().document.caseName() == "restored");
    verifyLogHasNoPath(*c);
    QVERIFY2(told().empty(), told().c_str());
  }

  void theLogHasNoPathWhereSomethingFails() {
    auto c = newWindow();
    c->window->open(text(damaged_));
    c->window->open(text(series_ / "none"));
    c->window->open(text(series_));
    c->models().runs.run(Step::Evolve);
    c->models().exports.exportMesh(MeshKind::Exported, text(planted_ / "none/a.ply"), {},
                                   {.report = true});
    c->answers.savePath = text(planted_ / "none/a.angiomesh");
    trigger(*c, "saveCase");
    verifyLogHasNoPath(*c);
    QVERIFY2(told().empty(), told().c_str());
  }

  /// Recent files and the places of the cases' volumes are no use without.
  void theSettingsHoldPathsForTheUserAlone() {
    auto c = newWindow();
    c->window->open(text(series_));
    QSettings settings;
    settings.sync();
    QVERIFY(settings.allKeys().contains("recent"));
    QVERIFY(settings.value("recent").toStringList().contains(text(series_)));
    const QFileInfo file(settings.fileName());
    QVERIFY(file.filePath().startsWith(text(home / "config")));
    const auto others = QFile::ReadGroup | QFile::ReadOther | QFile::ExeGroup | QFile::ExeOther;
    QVERIFY(!(QFileInfo(file.path()).permissions() & others));
    // Nothing from the headers.
    const std::string found =
        joined(identityIn(home / "config", {kUidRoot, kStudyDate, planted("1")}));
    QVERIFY2(found.empty(), found.c_str());
  }

  /// Qt's dialogs note folders in a file that all Qt programs of the user share.
  void fileDialogsNoteNoFolder() {
    const QString other = "file:///other";
    {
      QSettings shared(QSettings::UserScope, "QtProject");
      shared.setValue("FileDialog/history", QStringList{other});
    }
    const PathChooser chooser = dialogPathChooser();
    answerFileDialog(text(volumes_[0]));
    QCOMPARE(chooser.openFile(nullptr), text(volumes_[0]));
    answerFileDialog(text(series_));
    QCOMPARE(chooser.openFolder(nullptr), text(series_));
    answerFileDialog(text(series_ / "a.ply"));
    QCOMPARE(chooser.save(nullptr, "vessels.ply", "(*.ply)"), text(series_ / "a.ply"));
    answerFileDialog(text(series_ / "a.angiomesh"));
    QCOMPARE(dialogCaseQuestions().saveCaseAs(nullptr, "vessels.angiomesh"),
             text(series_ / "a.angiomesh"));
    const std::string found = joined(identityIn(home));
    QVERIFY2(found.empty(), found.c_str());
    const QSettings shared(QSettings::UserScope, "QtProject");
    QCOMPARE(shared.value("FileDialog/history").toStringList(), QStringList{other});
  }

  void pictures() {
    const QString out = text(home / "meshes");
    for (const QStringList& arguments :
         {QStringList{"run", text(series_), "-o", "run"},
          QStringList{"snapshot", "run", "-o", "surface.png"},
          QStringList{"study", "figures", "--image", text(volumes_[0]), "-o", "figures", "--set",
                      "preprocess.roi=2,2,2,13,13,13"}}) {
      const CliResult result = runCli(out, arguments);
      QVERIFY2(result.code == 0, result.errors.constData());
    }
    QVERIFY(fs::exists(home / "meshes/surface.png"));
    QVERIFY2(told().empty(), told().c_str());
  }
};

int main(int argc, char** argv) {
  const QTemporaryDir inputs;  // before the folder for temporary files moves into the home
  outside = inputs.path().toStdString();
  const QTemporaryDir folder;
  home = folder.path().toStdString();
  makeHome(home);
  prepareOpenGl();
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName("Angiomesh");
  QCoreApplication::setApplicationName("Angiomesh");
  TestPrivacyWindow test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_privacy_window.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QToolButton>
#include <algorithm>

#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/vessel/ports_file.h"
#include "io/volume/image_write.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using angiomesh::test::cutAt;
using angiomesh::test::PortCase;
using angiomesh::test::trigger;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

/// The export dialog with a format chosen; null when it does not open.
QDialog* exportAs(PortCase& c, int format) {
  c.trigger("export");
  auto* dialog = c.find<QDialog>("exportDialog");
  if (!dialog || !QTest::qWaitFor([&] { return dialog->isVisible(); })) {
    return nullptr;
  }
  c.choose(dialog->findChild<QComboBox*>("exportFormat"), format);
  return dialog;
}

}  // namespace

/// Cuts and the names of ports on their way into files and back.
class TestPortExports : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesAreExported_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("named");
    QTest::newRow("ply") << 0 << "v.ply" << true;
    QTest::newRow("ply text") << 1 << "v.ply" << true;
    QTest::newRow("stl") << 2 << "v.stl" << false;
    QTest::newRow("stl text") << 3 << "v.stl" << true;
    QTest::newRow("obj") << 4 << "v.obj" << true;
    QTest::newRow("off") << 5 << "v.off" << false;
    QTest::newRow("vtp") << 6 << "v.vtp" << true;
  }
  void namesAreExported() {
    QFETCH(int, format);
    QFETCH(QString, file);
    QFETCH(bool, named);
    PortCase c;
    c.cutAt(0.5);
    c.click(c.find<QPushButton>("run"));
    c.savePath = c.folder.filePath("v");
    QDialog* dialog = exportAs(c, format);
    QVERIFY(dialog);
    auto* hint = dialog->findChild<QLabel*>("exportHint");
    QCOMPARE(hint->text().contains("loses the names"), !named);
    QVERIFY(dialog->findChild<QCheckBox*>("exportPortsFile")->isChecked());
    QTest::mouseClick(dialog->findChild<QCheckBox*>("exportPatches"), Qt::LeftButton,
                      Qt::NoModifier, QPoint(8, 8));
    c.click(dialog->findChild<QPushButton*>("exportGo"));
    const LoadedMesh back = loadMesh(c.folder.filePath(file).toStdString());
    const bool has = std::count(back.patchNames.begin(), back.patchNames.end(), "inlet") == 1;
    QCOMPARE(has, named);
    const auto ports = readPorts(c.folder.filePath("v.ports.json").toStdString());
    QCOMPARE(ports.size(), c.models().results.ports(MeshKind::Exported).size());
    QCOMPARE(ports[0].name, std::string("inlet"));
    QVERIFY(QFile::exists(c.folder.filePath(QString(file).replace("v.", "v_inlet."))));
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QVERIFY2(log.contains("its ports"), qPrintable(log));
  }

  void aCaseForOpenFoamIsExported() {
    PortCase c;
    c.cutAt(0.5);
    c.click(c.find<QPushButton>("run"));
    c.savePath = c.folder.filePath("foam");
    QDialog* dialog = exportAs(c, 7);
    QVERIFY(dialog);
    QVERIFY(!dialog->findChild<QComboBox*>("exportUnit")->isEnabled());
    QVERIFY(!dialog->findChild<QLabel*>("exportHint")->text().contains("not connected"));
    c.click(dialog->findChild<QPushButton*>("exportGo"));
    QVERIFY2(QFile::exists(c.folder.filePath("foam/system/snappyHexMeshDict")),
             qPrintable(c.find<QPlainTextEdit>("log")->toPlainText()));
    QTRY_VERIFY(!c.find<QDialog>("exportDialog"));
    c.models().document.setField("segmentation.keep", std::string("all"));
    c.click(c.find<QPushButton>("run"));
    dialog = exportAs(c, 7);
    QVERIFY(dialog);
    QVERIFY(dialog->findChild<QLabel*>("exportHint")->text().contains("2 parts"));
  }

  void thePortsAloneAreExported() {
    PortCase c;
    c.cutAt(0.5);
    c.click(c.find<QPushButton>("run"));
    c.savePath = c.folder.filePath("openings");
    c.click(c.find<QToolButton>("exportPortsButton"));
    const auto ports = readPorts(c.folder.filePath("openings.json").toStdString());
    QCOMPARE(ports[0].name, std::string("inlet"));
    const auto log = [&] { return c.find<QPlainTextEdit>("log")->toPlainText(); };
    QVERIFY(!log().contains("earlier parameters"));
    c.ports().rename("inlet", "neck");
    c.click(c.find<QToolButton>("exportPortsButton"));
    QVERIFY(log().contains("earlier parameters"));
  }

  void aCaseKeepsItsCuts() {
    const QTemporaryDir folder;
    const QString volume = folder.filePath("tubes.mha"), saved = folder.filePath("t.angiomesh");
    writeVolume(*twoTubes().image, volume.toStdString());
    std::vector<std::string> cuts;
    {
      WindowCase c;
      c.window->open(volume);
      c.models().runs.run();
      cutAt(c, 0.5);
      c.window->ports().rename("inlet", "neck");
      cuts = c.models().document.parameters().ports.cuts;
      c.answers.savePath = saved;
      trigger(c, "saveCase");
      QVERIFY(!c.models().document.modified());
    }
    WindowCase c;
    c.window->open(saved);
    QVERIFY(c.models().document.parameters().ports.cuts == cuts);
    QVERIFY(c.window->ports().find("neck"));
    // Cuts mean something in one image alone, and nothing to a preset.
    c.models().presets.apply("thesis");
    QVERIFY(c.models().document.parameters().ports.cuts == cuts);
    c.models().files.take(twoTubes(36));
    QVERIFY(c.models().document.parameters().ports.cuts.empty());
  }

  void cutsComeBackAfterACrash() {
    const QTemporaryDir recovery;
    const QTemporaryDir folder;
    const QString volume = folder.filePath("tubes.mha");
    writeVolume(*twoTubes().image, volume.toStdString());
    std::vector<std::string> cuts;
    {
      WindowCase c(makeInlineJobRunner, recovery.path().toStdString());
      c.window->open(volume);
      c.models().runs.run();
      cutAt(c, 0.5);
      cuts = c.models().document.parameters().ports.cuts;
      QCOMPARE(cuts.size(), std::size_t(1));
    }
    WindowCase c(makeInlineJobRunner, recovery.path().toStdString());
    c.answers.restore = RestoreAnswer::Restore;
    QVERIFY(c.window->offerRestore());
    QTRY_VERIFY(c.models().document.parameters().ports.cuts == cuts);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestPortExports>(argc, argv); }
#include "tst_port_exports.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>

#include "core/pipeline/segmentation_mask.h"
#include "io/scan/image_io.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using angiomesh::test::PortCase;
using angiomesh::test::trigger;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

QString logOf(WindowCase& c) { return c.find<QPlainTextEdit>("log")->toPlainText(); }

/// The export dialog with the mask chosen; null when it does not open.
QDialog* exportMask(WindowCase& c) {
  trigger(c, "export");
  auto* dialog = c.find<QDialog>("exportDialog");
  if (!dialog || !QTest::qWaitFor([&] { return dialog->isVisible(); })) {
    return nullptr;
  }
  auto* what = dialog->findChild<QComboBox*>("exportMesh");
  c.choose(what, what->count() - 1);
  return dialog;
}

void go(WindowCase& c, QDialog* dialog) {
  c.click(dialog->findChild<QPushButton*>("exportGo"));
  QTRY_VERIFY(!c.find<QDialog>("exportDialog"));
}

std::size_t inside(const Volume<std::uint8_t>& mask) {
  return static_cast<std::size_t>(std::count(mask.voxels.begin(), mask.voxels.end(), 1));
}

/// Exports a mask as NRRD and reads it.
Volume<std::uint8_t> exported(WindowCase& c, const QString& name) {
  c.savePath = c.folder.filePath(name + ".nrrd");
  c.models().exports.exportMask(c.savePath);
  return readMask(c.savePath.toStdString()).mask;
}

}  // namespace

/// The mask of the segmentation shown on its way into files.
class TestMaskExports : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyFormatHoldsTheMaskOfTheRun_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<QString>("file");
    QTest::newRow("MetaImage") << 0 << "v.mha";
    QTest::newRow("NRRD") << 1 << "v.nrrd";
    QTest::newRow("NIfTI") << 2 << "v.nii.gz";
  }
  void everyFormatHoldsTheMaskOfTheRun() {
    QFETCH(int, format);
    QFETCH(QString, file);
    PortCase c;
    c.savePath = c.folder.filePath("v");
    QDialog* dialog = exportMask(c);
    QVERIFY(dialog);
    c.choose(dialog->findChild<QComboBox*>("exportFormat"), format);
    QVERIFY(!dialog->findChild<QWidget*>("exportUnit")->isVisible());
    QVERIFY(!dialog->findChild<QWidget*>("exportPatches")->isVisible());
    QVERIFY(dialog->findChild<QLabel*>("exportSize")->text().startsWith("40 × 40 × 40 voxels"));
    go(c, dialog);
    const RunResult& run = *c.models().results.meshRun();
    const Volume<std::uint8_t> wanted = segmentationMask(run, run.source.image->geometry);
    const Volume<std::uint8_t> back = readMask(c.folder.filePath(file).toStdString()).mask;
    QVERIFY(back.voxels == wanted.voxels);
    QVERIFY(back.geometry.origin.isApprox(wanted.geometry.origin, 1e-6));
    QVERIFY(inside(back) > 0);
    const QString said = QString("a mask of %1 voxels").arg(inside(back));
    QVERIFY2(logOf(c).contains(said), qPrintable(logOf(c)));
  }

  void aMaskNeedsNoMesh() {
    WindowCase c;
    c.models().files.take(twoTubes());
    QVERIFY(!c.window->findChild<QAction*>("export")->isEnabled());
    c.models().exports.exportMask(c.folder.filePath("none.nrrd"));
    QVERIFY(logOf(c).contains("no segmentation to export"));
    c.models().runs.run(Step::Evolve);
    QVERIFY(!c.models().results.meshRun());
    c.savePath = c.folder.filePath("v");
    QDialog* dialog = exportMask(c);
    QVERIFY(dialog);
    QCOMPARE(dialog->findChild<QComboBox*>("exportMesh")->count(), 1);
    go(c, dialog);
    QVERIFY2(QFile::exists(c.folder.filePath("v.mha")), qPrintable(logOf(c)));
  }

  void partsThatAreTickedOffAreLeftOut() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.models().runs.run();
    const std::size_t both = inside(exported(c, "both"));
    const std::vector<ComponentRow> rows = c.models().results.components();
    QCOMPARE(rows.size(), std::size_t(2));
    c.models().results.setComponentTicked(1, false);
    // As the mesh that is shown: it still has the part, and says so.
    QVERIFY(!c.models().results.segmentationFresh());
    QCOMPARE(inside(exported(c, "stale")), both);
    QVERIFY(logOf(c).contains("belongs to earlier parameters"));
    c.models().runs.run();
    const std::size_t one = inside(exported(c, "one"));
    QVERIFY2(one < both && one > both / 3, qPrintable(QString::number(one)));
    // Of a segmentation without a mesh, too.
    c.models().document.setField("levelset.xi", 31.0);
    c.models().runs.run(Step::Evolve);
    QVERIFY(!c.models().results.meshFits());
    const std::size_t again = inside(exported(c, "again"));
    QVERIFY2(again < both && again > both / 3, qPrintable(QString::number(again)));
    c.models().results.setComponentTicked(1, true);
    const std::size_t ticked = inside(exported(c, "ticked"));
    QVERIFY2(ticked > again + again / 2, qPrintable(QString::number(ticked)));
  }

  void nothingIsLeftWhereItCannotBeWritten() {
    PortCase c;
    c.models().exports.exportMask(c.folder.filePath("none/v.nrrd"));
    QVERIFY2(logOf(c).contains("Cannot export"), qPrintable(logOf(c)));
    QVERIFY(!logOf(c).contains(c.folder.path()));
    QVERIFY(QDir(c.folder.path()).isEmpty());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestMaskExports>(argc, argv); }
#include "tst_mask_exports.moc"

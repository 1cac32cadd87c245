// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <cmath>
#include <numeric>

#include "gui/inspector/histogram_widget.h"
#include "io/mesh/mesh_io.h"
#include "io/volume/image_write.h"
#include "window_case.h"

using namespace angiomesh;
using angiomesh::test::evolveFor;
using angiomesh::test::kLongEvolution;
using angiomesh::test::kPatienceMs;
using angiomesh::test::litShare;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

class TestWindowRun : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theEvolutionIsPausedSteppedAndFinished() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    evolveFor(c.models());
    auto* pause = c.find<QPushButton>("pause");
    auto* step = c.find<QPushButton>("step");
    auto* finish = c.find<QPushButton>("finish");
    QVERIFY(!pause->isEnabled() && !step->isEnabled() && !finish->isEnabled());
    QSignalSpy snapshots(&c.models().runs, &RunModel::snapshotArrived);
    c.click(c.find<QPushButton>("run"));
    QTRY_VERIFY_WITH_TIMEOUT(snapshots.size() >= 2, kPatienceMs);
    QVERIFY(!c.find<QPushButton>("run")->isEnabled());
    QVERIFY(pause->isEnabled() && !step->isEnabled() && finish->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.history().size() >= 2, kPatienceMs);
    QVERIFY(c.find<QLabel>("evolutionText")->text().contains("change"));

    c.click(pause);
    QTRY_COMPARE(pause->text(), QString("Resume"));
    QVERIFY(step->isEnabled());
    int before = -1;
    QTRY_VERIFY_WITH_TIMEOUT(
        std::exchange(before, c.models().runs.iterations()) == c.models().runs.iterations(),
        kPatienceMs);
    c.click(step);
    QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.iterations() >= before + 10, kPatienceMs);
    c.click(finish);
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), kPatienceMs);
    QVERIFY(c.models().runs.state(Step::Quality) == StepState::Fresh);
    QVERIFY(!pause->isEnabled() && !finish->isEnabled());
    QVERIFY(c.find<QPlainTextEdit>("log")->toPlainText().contains("Done up to Quality"));
  }

  void theSurfaceMovesTwicePerSecond() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    evolveFor(c.models());
    QSignalSpy snapshots(&c.models().runs, &RunModel::snapshotArrived);
    QSignalSpy drawn(c.window->views().surface(), &VtkView::rendered);
    c.click(c.find<QPushButton>("run"));
    QTRY_VERIFY_WITH_TIMEOUT(snapshots.size() >= 1, kPatienceMs);
    QElapsedTimer timer;
    timer.start();
    const auto first = snapshots.size();
    const auto firstDrawn = drawn.size();
    QTRY_VERIFY_WITH_TIMEOUT(snapshots.size() >= first + 8, kPatienceMs);
    // 2 per second, and as much again for a machine that does other work besides.
    QVERIFY2(timer.elapsed() < 8000, qPrintable(QString::number(timer.elapsed())));
    QVERIFY(drawn.size() > firstDrawn);
    c.click(c.find<QPushButton>("cancel"));
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), 3000);
    QVERIFY(c.find<QPlainTextEdit>("log")->toPlainText().contains("Cancelled"));
    QVERIFY(c.find<QPushButton>("run")->isEnabled());
  }

  void aSliderMovedInMidRunRestartsIt() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    evolveFor(c.models(), kLongEvolution);
    c.click(c.find<QPushButton>("run"));
    QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.evolving() && c.models().runs.iterations() > 0,
                             kPatienceMs);
    const auto vesselness = c.models().results.vesselnessResult();
    auto* slider = c.find<QSlider>("slider", "field:levelset.gamma");
    for (int i = 0; i < 5; ++i) {
      QTest::keyClick(slider, Qt::Key_PageUp);
    }
    QVERIFY(c.models().document.parameters().levelset.gamma > 0.7);
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running(), kPatienceMs);
    QVERIFY(c.models().runs.state(Step::Quality) == StepState::Fresh);
    QVERIFY(c.models().results.vesselnessResult() == vesselness);
  }

  void closesWhileRunning() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    evolveFor(c.models());
    c.click(c.find<QPushButton>("run"));
    QTRY_VERIFY_WITH_TIMEOUT(c.models().runs.evolving(), kPatienceMs);
    QVERIFY(c.window->close());
    c.window.reset();
  }

  void opensAndRunsAtOnce() {
    WindowCase c;
    const QString path = c.folder.filePath("tubes.mha");
    writeVolume(*twoTubes().image, path.toStdString());
    c.window->open(c.folder.filePath("missing.mha"), true);
    c.window->open(path);
    QCoreApplication::processEvents();
    QVERIFY(!c.models().results.layer(Layer::Preprocessed));
    c.window->open(path, true);
    QTRY_VERIFY(c.models().results.meshFresh());
  }

  void theInspectorShowsNumbersAndColours() {
    WindowCase c;
    auto* table = c.find<QTableWidget>("quality");
    QCOMPARE(table->item(0, 0)->text(), QString("–"));
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    for (int kind = 0; kind < kRunMeshCount; ++kind) {
      QCOMPARE(QLocale().toULongLong(table->item(0, kind)->text()),
               static_cast<qulonglong>(
                   c.models().results.mesh(static_cast<MeshKind>(kind))->triangles.size()));
      const auto& shares =
          c.find<HistogramWidget>("histogram")->shares(static_cast<MeshKind>(kind));
      QVERIFY(std::abs(std::accumulate(shares.begin(), shares.end(), 0.0) - 100.0) < 1e-6);
    }
    QVERIFY(c.find<QLabel>("hints")->text().contains("closed"));
    SurfaceView* view = c.window->views().surface();
    c.clickTool("mip");
    const QImage plain = view->grabFramebuffer();
    c.choose(c.find<QComboBox>("meshColour"), 1);
    const QImage angles = view->grabFramebuffer();
    QVERIFY(angles != plain);
    c.choose(c.find<QComboBox>("meshColour"), 2);
    QVERIFY(view->grabFramebuffer() != angles);
    c.choose(c.find<QComboBox>("meshColour"), 0);
    SurfaceView* beside = c.window->views().comparison();
    QVERIFY(beside->isHidden());
    QTest::mouseClick(c.find<QCheckBox>("comparison"), Qt::LeftButton, Qt::NoModifier,
                      QPoint(8, 8));
    QTRY_VERIFY(beside->isVisible());
    // Once both have half of the room, they show two triangulations of one surface alike.
    QTRY_VERIFY(beside->width() > 20 && std::abs(beside->width() - view->width()) < 3);
    QVERIFY(beside->grabFramebuffer() != view->grabFramebuffer());
    QTest::mouseClick(c.find<QCheckBox>("comparison"), Qt::LeftButton, Qt::NoModifier,
                      QPoint(8, 8));
    QTRY_VERIFY(!beside->isVisible());
    c.choose(c.find<QComboBox>("meshShown"), 2);
    QVERIFY(c.state().meshKind() == MeshKind::MarchingCubes);
    c.models().document.setField("smooth.iterations", std::int64_t(7));
    QVERIFY(c.find<QLabel>("hints")->text().contains("earlier parameters"));
  }

  void whatIsOutOfDateIsDimmedAndSaysSo() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.state().setVolumeView(VolumeView::None);
    c.click(c.find<QPushButton>("run"));
    const auto pictures = [&] {
      return std::vector<QImage>{c.window->views().slice(2)->grabFramebuffer(),
                                 c.window->views().surface()->grabFramebuffer()};
    };
    auto* hints = c.find<QLabel>("hints");
    auto* parts = c.find<QLabel>("componentSummary");
    QVERIFY2(hints->text().startsWith("Result 1\n"), qPrintable(hints->text()));
    QCOMPARE(parts->text(), QString("Result 1. Parts: 2"));
    const std::vector<QImage> fresh = pictures();
    c.models().document.setField("levelset.xi", 35.0);
    QVERIFY2(hints->text().contains("Result 1 belongs to earlier"), qPrintable(hints->text()));
    QCOMPARE(parts->text(), QString("Result 1, out of date. Parts: 2"));
    const std::vector<QImage> stale = pictures();
    QVERIFY(stale[0] != fresh[0]);
    QVERIFY(litShare(stale[1]) < 0.8 * litShare(fresh[1]));
    c.clickTool("undo");
    QVERIFY(hints->text().startsWith("Result 1\n"));
    QVERIFY(pictures() == fresh);
  }

  void everyFormatIsExportedAndReadBack_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("start");
    QTest::addColumn<bool>("metres");
    QTest::newRow("ply") << 0 << "vessels.ply" << QByteArray("ply\nformat binary") << false;
    QTest::newRow("ply text") << 1 << "vessels.ply" << QByteArray("ply\nformat ascii") << true;
    QTest::newRow("stl") << 2 << "vessels.stl" << QByteArray("Angiomesh SPACE=LPS") << false;
    QTest::newRow("stl text") << 3 << "vessels.stl" << QByteArray("solid wall SPACE=RAS") << true;
    QTest::newRow("obj") << 4 << "vessels.obj" << QByteArray("# Angiomesh") << false;
    QTest::newRow("off") << 5 << "vessels.off" << QByteArray("OFF\n# Angiomesh") << false;
    QTest::newRow("vtp") << 6 << "vessels.vtp" << QByteArray("<?xml") << true;
  }
  void everyFormatIsExportedAndReadBack() {
    QFETCH(int, format);
    QFETCH(QString, file);
    QFETCH(QByteArray, start);
    QFETCH(bool, metres);
    WindowCase c;
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    c.savePath = c.folder.filePath("vessels");
    c.clickTool("export");
    auto* dialog = c.find<QDialog>("exportDialog");
    QVERIFY(dialog);
    QTRY_VERIFY(dialog->isVisible());
    const auto combo = [&](const char* name) { return dialog->findChild<QComboBox*>(name); };
    const auto check = [&](const char* name) { return dialog->findChild<QCheckBox*>(name); };
    const auto tick = [&](const char* name) {
      QTest::mouseClick(check(name), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
    };
    QCOMPARE(combo("exportFormat")->count(), 8);
    c.choose(combo("exportFormat"), format);
    auto* hint = dialog->findChild<QLabel*>("exportHint");
    // STL has no topology, OFF no names of the ports.
    QCOMPARE(hint->isVisible(), file.endsWith(".stl") || file.endsWith(".off"));
    QCOMPARE(hint->text().contains("topology"), file.endsWith(".stl"));
    const bool extras = file.endsWith(".ply") || file.endsWith(".vtp");
    QCOMPARE(check("exportNormals")->isEnabled(), extras);
    QCOMPARE(check("exportQuality")->isEnabled(), extras);
    tick("exportNormals");
    tick("exportQuality");
    auto* size = dialog->findChild<QLabel*>("exportSize");
    QVERIFY(size->text().endsWith(" mm"));
    if (metres) {
      c.choose(combo("exportUnit"), 1);
      c.choose(combo("exportFrame"), 1);
      QVERIFY(size->text().endsWith(" m"));
      tick("exportReport");
    }
    const QString shown = size->text();
    c.click(dialog->findChild<QPushButton*>("exportGo"));
    QTRY_VERIFY(!c.find<QDialog>("exportDialog"));

    const QString path = c.folder.filePath(file);
    QFile written(path);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.read(start.size()) == start);
    const LoadedMesh back = loadMesh(path.toStdString());
    QCOMPARE(back.mesh.triangles.size(),
             c.models().results.mesh(MeshKind::Exported)->triangles.size());
    QVERIFY(back.unit == (metres ? LengthUnit::Metre : LengthUnit::Millimetre));
    QVERIFY(back.frame == (metres ? Frame::Ras : Frame::Lps));
    QVERIFY(!back.key.empty());
    QVERIFY(back.hasNormals == extras && back.hasQuality == extras);
    QCOMPARE(QFile::exists(c.folder.filePath("vessels.report.json")), !metres);
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QVERIFY2(log.contains("Wrote " + file) && log.contains("Read back: "), qPrintable(log));
    QVERIFY2(log.contains(shown + (metres ? " in RAS" : " in LPS")), qPrintable(log));
  }

  void anExportToNowhereSaysSo() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    c.savePath = c.folder.filePath("missing/vessels.ply");
    c.clickTool("export");
    c.click(c.find<QDialog>("exportDialog")->findChild<QPushButton*>("exportGo"));
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QVERIFY2(log.contains("Cannot export"), qPrintable(log));
    QVERIFY(!QFile::exists(c.folder.filePath("missing")));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestWindowRun>(argc, argv); }
#include "tst_window_run.moc"

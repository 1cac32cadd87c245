// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QTableWidget>
#include <QToolButton>

#include "core/parameters/field.h"
#include "io/volume/image_write.h"
#include "window_case.h"

using namespace angiomesh;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

class TestMainWindow : public QObject {
  Q_OBJECT

 private:
  static QString saveTubes(const WindowCase& c) {
    const QString path = c.folder.filePath("tubes.mha");
    writeVolume(*twoTubes().image, path.toStdString());
    return path;
  }

 private Q_SLOTS:
  void opensAFileThroughTheDialog() {
    WindowCase c;
    c.openPath = saveTubes(c);
    c.clickTool("open");
    QVERIFY(c.window->windowTitle().startsWith("tubes ("));
    QVERIFY(c.window->windowTitle().endsWith(")[*] — Angiomesh"));
    for (int plane = 0; plane < 3; ++plane) {
      QCOMPARE(c.window->views().slice(plane)->sliceCount(), 40);
    }
    QCOMPARE(QSettings().value("recent").toStringList(), QStringList{c.openPath});
    c.openPath.clear();
    c.clickTool("open");
    QCOMPARE(c.models().document.caseName(), QString("tubes"));
  }

  void takesAFileThatIsDropped() {
    WindowCase c;
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(saveTubes(c))});
    QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(c.window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(400, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(c.window.get(), &drop);
    QCOMPARE(c.models().document.caseName(), QString("tubes"));
  }

  void aBadFileGivesALine() {
    WindowCase c;
    c.openPath = c.folder.filePath("broken.nrrd");
    QFile file(c.openPath);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("NRRD0004\n");
    file.close();
    c.clickTool("open");
    const QString log = c.find<QPlainTextEdit>("log")->toPlainText();
    QCOMPARE(log.count('\n'), 0);
    QVERIFY2(log.contains("Error") && log.contains("broken"), qPrintable(log));
    QVERIFY(!c.models().document.hasCase());
    QVERIFY(!c.find<QPushButton>("run")->isEnabled());
  }

  void theSampleOpensByItsMenuEntry() {
    WindowCase c;
    c.window->findChild<QAction*>("openSample")->trigger();
    QCOMPARE(c.window->windowTitle(), QString("sample[*] — Angiomesh"));
    QCOMPARE(c.models().document.image()->geometry.size[0], 128);
  }

  void slidersMakeStepsStaleAndUndoMakesThemFresh() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().runs.state(Step::Quality) == StepState::Fresh);
    auto* slider = c.find<QSlider>("slider", "field:levelset.xi");
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.orientation = Qt::Horizontal;
    option.maximum = slider->maximum();
    option.sliderPosition = option.sliderValue = slider->value();
    const QPoint handle =
        slider->style()
            ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider)
            .center();
    c.drag(slider, handle, handle + QPoint(12, 0));
    QVERIFY(c.models().document.parameters().thresholds.xi > 20.0);
    QVERIFY(c.models().runs.state(Step::Seeds) == StepState::Fresh);
    QVERIFY(c.models().runs.state(Step::Evolve) == StepState::Stale);
    QVERIFY(c.models().runs.state(Step::Quality) == StepState::Stale);
    QCOMPARE(c.find<QLabel>("state", "step:evolve")->text(), QString("stale"));
    QCOMPARE(c.models().document.undoStack()->count(), 1);
    c.clickTool("undo");
    QCOMPARE(c.models().document.parameters().thresholds.xi, 20.0);
    QCOMPARE(c.find<QDoubleSpinBox>("spin", "field:levelset.xi")->value(), 20.0);
    QVERIFY(c.models().runs.state(Step::Quality) == StepState::Fresh);
    c.clickTool("redo");
    QVERIFY(c.models().runs.state(Step::Evolve) == StepState::Stale);
  }

  void vesselSizesAreShownAsDiameters() {
    WindowCase c;
    c.models().files.take(twoTubes());
    auto* spin = c.find<QDoubleSpinBox>("spin", "field:vesselness.sigmaMinMm");
    QVERIFY(!spin->isEnabled());
    QCOMPARE(spin->value(), 1.0);
    QTest::mouseClick(c.find<QCheckBox>("empty", "field:vesselness.sigmaMinMm"), Qt::LeftButton,
                      Qt::NoModifier, QPoint(8, 8));
    QVERIFY(spin->isEnabled());
    QCOMPARE(*c.models().document.parameters().vesselness.sigmaMinMm, 0.5);
    spin->selectAll();
    QTest::keyClicks(spin, "1.6");
    QTest::keyClick(spin, Qt::Key_Return);
    QCOMPARE(*c.models().document.parameters().vesselness.sigmaMinMm, 0.8);
  }

  void everyFieldHasAnEditorOfItsKind() {
    WindowCase c;
    for (const Field& field : parameterFields()) {
      const QString name = "field:" + QString::fromStdString(field.key);
      const char* kinds[] = {"check", "spin", "spin", "combo", "clear", "clear"};
      QVERIFY2(c.find<QWidget>(kinds[static_cast<int>(field.kind)], name), qPrintable(name));
      const bool hidden = c.find<QWidget>(name)->parentWidget()->objectName() == "rest";
      QCOMPARE(hidden, !field.main);
    }
  }

  void theStepEvolveChoosesTheMethod() {
    WindowCase c;
    const QStringList evolve{"segmentation.method", "comparison.threshold.lower", "levelset.xi"};
    for (const QString& key : evolve) QVERIFY(c.find<QWidget>("field:" + key, "step:evolve"));
    auto* combo = c.find<QComboBox>("combo", "field:segmentation.method");
    auto* xi = c.find<QWidget>("spin", "field:levelset.xi");
    auto* lower = c.find<QWidget>("empty", "field:comparison.threshold.lower");
    QVERIFY(xi->isEnabled() && !lower->isEnabled());
    c.choose(combo, combo->findText("threshold"));
    QCOMPARE(c.models().document.parameters().segmentation.method, SegmentationMethod::Threshold);
    QVERIFY(!xi->isEnabled() && lower->isEnabled());
  }

  void moreShowsTheRest() {
    WindowCase c;
    auto* rest = c.find<QWidget>("rest", "step:surface");
    QVERIFY(!rest->isVisible());
    QTest::mouseClick(c.find<QToolButton>("more", "step:surface"), Qt::LeftButton);
    QVERIFY(rest->isVisible());
    auto* spline = c.find<QComboBox>("combo", "field:surface.spline");
    c.choose(spline, 1);
    QVERIFY(c.models().document.parameters().surface.spline == SplineKind::Bspline);
  }

  void fieldsWithoutEffectAreDisabledAndSayWhy() {
    WindowCase c;
    auto* mu = c.find<QWidget>("field:smooth.mu");
    auto* bound = c.find<QWidget>("field:smooth.wallBoundVoxels");
    QVERIFY(!mu->isEnabled() && !bound->isEnabled());
    c.models().document.setField("surface.method", std::string("marching-cubes"));
    QVERIFY(!mu->isEnabled() && bound->isEnabled());
    QVERIFY2(mu->toolTip().contains("taubin"), qPrintable(mu->toolTip()));
    c.choose(c.find<QComboBox>("combo", "field:smooth.method"), 1);
    QVERIFY(mu->isEnabled() && !bound->isEnabled());
    QVERIFY(!mu->toolTip().contains("Has no effect"));
  }

  void theSurfaceFormFollowsItsMethod() {
    WindowCase c;
    auto* rho = c.find<QWidget>("field:surface.rho");
    auto* cell = c.find<QWidget>("field:surface.cellVoxels");
    QVERIFY(rho->isEnabled() && !cell->isEnabled());
    c.choose(c.find<QComboBox>("combo", "field:surface.method"), 1);
    QVERIFY(c.models().document.parameters().surface.method == SurfaceMethod::MarchingCubes);
    QVERIFY(!rho->isEnabled() && cell->isEnabled());
    QVERIFY2(rho->toolTip().contains("marching cubes"), qPrintable(rho->toolTip()));
    c.choose(c.find<QComboBox>("combo", "field:surface.border"), 1);
    QVERIFY(c.models().document.parameters().surface.border == SurfaceBorder::Open);
    // A limit that is switched on begins with a length of this image, and keeps its partner.
    QVERIFY(!c.models().document.parameters().surface.sizing.edgeMaxMm);
    c.models().document.setField("surface.edgeMaxMm", 0.5);
    c.models().document.setField("surface.edgeMinMm", 0.8);
    QCOMPARE(*c.models().document.parameters().surface.sizing.edgeMaxMm, 0.8);
  }

  void trianglesAreExpectedAndThenCounted() {
    WindowCase c;
    auto* note = c.find<QLabel>("surfaceNote");
    c.models().files.take(twoTubes());
    QVERIFY(note->isHidden());
    c.models().runs.run(Step::Evolve);
    QVERIFY2(note->text().contains("about"), qPrintable(note->text()));
    const double usual = *c.models().results.estimatedTriangles();
    c.models().document.setField("surface.edgeMinVoxels", 0.3);
    QVERIFY(*c.models().results.estimatedTriangles() > 1.5 * usual);
    c.models().document.setField("surface.edgeMinVoxels", 0.4);
    c.models().runs.run(Step::Surface);
    QVERIFY2(note->text().contains("from the front"), qPrintable(note->text()));
    QVERIFY2(note->text().contains("verified"), qPrintable(note->text()));
    c.models().document.setField("surface.method", std::string("marching-cubes"));
    QVERIFY(!c.models().results.estimatedTriangles());
    QVERIFY(note->isHidden());
  }

  void theInspectorComparesThreeMeshes() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    auto* table = c.find<QTableWidget>("quality");
    for (int kind = 0; kind < table->columnCount(); ++kind)
      QCOMPARE(table->isColumnHidden(kind), kind == static_cast<int>(MeshKind::File));
    QCOMPARE(table->verticalHeaderItem(0)->text(), QString("Triangles"));
    const auto rowOf = [table](const QString& title) {
      for (int row = 0; row < table->rowCount(); ++row) {
        if (table->verticalHeaderItem(row)->text() == title) {
          return row;
        }
      }
      return -1;
    };
    const int front = rowOf("From the front, %"), verified = rowOf("Verified parts");
    QVERIFY(front > 0 && verified > 0);
    for (const int row : {front, verified}) {
      QVERIFY(table->item(row, 0)->text() != QString("–"));
      QVERIFY(table->item(row, 1)->text() != QString("–"));
      QCOMPARE(table->item(row, 2)->text(), QString("–"));
    }
    const SurfaceOrigin* origin = c.models().results.surfaceOrigin();
    QVERIFY(origin && !origin->components.empty());
    QCOMPARE(table->item(verified, 1)->toolTip().isEmpty(), origin->warnings().empty());
  }

  void presetsAreChosen() {
    WindowCase c;
    auto* preset = c.find<QComboBox>("preset");
    c.choose(preset, preset->findText("thesis"));
    QVERIFY(c.models().document.parameters().smooth.method == SmoothMethod::Taubin);
    c.models().document.setField("levelset.d", 0.5);
    QCOMPARE(preset->currentIndex(), -1);
  }

  void aClickOnASlicePicksASeed() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.clickTool("toolSeed");
    SliceView* axial = c.window->views().slice(2);
    const QPoint at(axial->width() / 3, axial->height() / 2);
    const Eigen::Vector3d expected = axial->lpsAt(at);
    QTest::mouseClick(axial, Qt::LeftButton, Qt::NoModifier, at);
    QCOMPARE(c.models().document.seeds().size(), std::size_t(1));
    QVERIFY((c.models().document.seeds().front() - expected).norm() < 1e-6);
    auto* list = c.find<QListWidget>("seedList");
    QCOMPARE(list->count(), 1);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier,
                      list->visualItemRect(list->item(0)).center());
    c.click(c.find<QPushButton>("removeSeed"));
    QVERIFY(c.models().document.seeds().empty());
    c.clickTool("undo");
    QCOMPARE(list->count(), 1);
  }

  void aDragOnASliceDrawsTheRegion() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.clickTool("toolRoi");
    SliceView* axial = c.window->views().slice(2);
    const QPoint centre = axial->rect().center();
    c.drag(axial, centre - QPoint(60, 50), centre + QPoint(60, 50));
    QVERIFY(c.models().document.parameters().preprocess.roi.has_value());
    QVERIFY(c.state().tool() == Tool::Navigate);
    QTest::mouseClick(c.find<QToolButton>("runToHere", "step:preprocess"), Qt::LeftButton);
    const Geometry& cropped = c.models().results.layer(Layer::Preprocessed)->geometry;
    QVERIFY(cropped.size[0] < 40 && cropped.size[1] < 40);
    QTest::mouseClick(c.find<QToolButton>("more", "step:preprocess"), Qt::LeftButton);
    c.click(c.find<QPushButton>("clear", "field:preprocess.roi"));
    QVERIFY(!c.models().document.parameters().preprocess.roi.has_value());
  }

  void aPartIsTickedOffInTheTable() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    const std::size_t before = c.models().results.mesh(MeshKind::Exported)->triangles.size();
    auto* table = c.find<QTableWidget>("components");
    QCOMPARE(table->rowCount(), 2);
    const QRect cell = table->visualItemRect(table->item(1, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier,
                      QPoint(cell.left() + 12, cell.center().y()));
    QTRY_VERIFY(c.models().runs.state(Step::Surface) == StepState::Stale);
    QVERIFY(table->item(1, 0)->checkState() == Qt::Unchecked);
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.mesh(MeshKind::Exported)->triangles.size() < before);
    c.clickTool("undo");
    QVERIFY(table->item(1, 0)->checkState() == Qt::Checked);
  }

  void layersAreSwitched() {
    WindowCase c;
    c.models().files.take(twoTubes());
    auto* layer = c.find<QComboBox>("layer");
    c.choose(layer, 2);
    QVERIFY(c.state().layer() == Layer::Source);
    QTest::mouseClick(c.find<QToolButton>("runToHere", "step:vesselness"), Qt::LeftButton);
    SliceView* axial = c.window->views().slice(2);
    const QImage source = axial->grabFramebuffer();
    const double window = axial->windowWidth();
    for (const Layer wanted : {Layer::Preprocessed, Layer::Vesselness, Layer::Speed}) {
      c.choose(layer, static_cast<int>(wanted));
      QVERIFY(c.state().layer() == wanted);
    }
    QCOMPARE(axial->windowWidth(), 2.0);
    QVERIFY(axial->grabFramebuffer() != source);
    c.choose(layer, 0);
    QCOMPARE(axial->windowWidth(), window);
    QVERIFY(axial->grabFramebuffer() == source);
  }

  void panesAreLinked() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    SliceView* axial = views.slice(2);
    const double before = axial->windowWidth();
    const QPoint centre = axial->rect().center();
    c.drag(axial, centre, centre + QPoint(40, 20));
    QVERIFY(axial->windowWidth() != before);
    QCOMPARE(views.slice(0)->windowWidth(), axial->windowWidth());
    QCOMPARE(views.slice(1)->windowLevel(), axial->windowLevel());
    c.window->findChild<QAction*>("resetWindow")->trigger();
    QCOMPARE(axial->windowWidth(), before);
    QTest::keyClick(axial, Qt::Key_Up);
    QVERIFY((views.slice(0)->cursor() - axial->cursor()).norm() < 1e-6);
  }

  void aDoubleClickMaximisesAPane() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    QTest::mouseDClick(views.slice(1), Qt::LeftButton);
    QVERIFY(views.maximised());
    QVERIFY(views.slice(1)->isVisible() && !views.slice(0)->isVisible());
    QTRY_VERIFY(views.slice(1)->width() > views.width() - 10);
    QTest::mouseDClick(views.slice(1), Qt::LeftButton);
    QVERIFY(views.surface()->isVisible());
    QTRY_VERIFY(views.slice(1)->width() < views.width() - 10);
  }

  void slabsAreChosen() {
    WindowCase c;
    c.models().files.take(twoTubes());
    auto* thickness = c.find<QDoubleSpinBox>("thickness");
    QVERIFY(!thickness->isEnabled());
    c.choose(c.find<QComboBox>("slab"), 1);
    QVERIFY(thickness->isEnabled());
    thickness->selectAll();
    QTest::keyClicks(thickness, "6");
    QTest::keyClick(thickness, Qt::Key_Return);
    for (int plane = 0; plane < 3; ++plane)
      QVERIFY((c.window->views().slice(plane)->slab() == Slab{SlabMode::Mip, 6.0}));
  }

  void contoursAndSurfaceAreSwitched() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.click(c.find<QPushButton>("run"));
    ViewGrid& views = c.window->views();
    const QImage with = views.slice(2)->grabFramebuffer();
    c.clickTool("contours");
    QVERIFY(views.slice(2)->grabFramebuffer() != with);
    c.clickTool("contours");
    QVERIFY(views.slice(2)->grabFramebuffer() == with);
    c.clickTool("mip");
    const QImage surface = views.surface()->grabFramebuffer();
    c.clickTool("surface");
    QVERIFY(views.surface()->grabFramebuffer() != surface);
  }

  void shortcutsAreListed() {
    WindowCase c;
    QTest::keyClick(c.window.get(), Qt::Key_F1);
    QTRY_VERIFY(c.find<QTableWidget>("shortcutsTable"));
    QVERIFY(c.find<QTableWidget>("shortcutsTable")->rowCount() > 20);
  }

  void noTwoActionsShareAShortcut() {
    WindowCase c;
    QStringList seen;
    for (const QAction* action : c.window->findChildren<QAction*>()) {
      if (!action->shortcut().isEmpty()) {
        QVERIFY2(!seen.contains(action->shortcut().toString()), qPrintable(action->text()));
        seen << action->shortcut().toString();
      }
    }
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestMainWindow>(argc, argv); }
#include "tst_main_window.moc"

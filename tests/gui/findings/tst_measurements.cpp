// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <cmath>
#include <functional>

#include "core/measure/vessel_profile.h"
#include "gui/findings/case_measures.h"
#include "gui/job/job_runner.h"
#include "gui/panel/profile_plot.h"
#include "io/vessel/measurements_file.h"
#include "tests/gui/port_case.h"
#include "tests/gui/study_case.h"

using namespace angiomesh;
using angiomesh::test::insideOf;
using angiomesh::test::kPatienceMs;
using angiomesh::test::Study;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

/// A tube of 5 voxels' radius that narrows to half of it in the middle, voxels of 0.5 mm.
Source narrowedTube() {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = PhantomKind::Stenosis;
  params.size = {48, 48, 56};
  params.spacingMm = {0.5, 0.5, 0.5};
  params.radius = 5.0;
  params.stenosisPercent = 50.0;
  return makeSource(makePhantom(params).image, "narrowed");
}

/// In line, but as if it were still at work for as long as it is held.
struct HeldRunner final : JobRunner {
  explicit HeldRunner(const bool& hold) : hold_(hold) {}
  void start(std::function<void()> work) override {
    work();
    held_ = hold_;
  }
  [[nodiscard]] bool running() const override { return held_; }
  void wait() override {}
  void release() { held_ = false; }

 private:
  const bool& hold_;
  bool held_ = false;
};

/// A window in which vessels are segmented, or only shown.
struct MeasureCase : WindowCase {
  explicit MeasureCase(Source source = twoTubes(), bool segmented = true,
                       const JobRunnerFactory& makeRunner = makeInlineJobRunner)
      : WindowCase(makeRunner) {
    models().files.take(std::move(source));
    for (int waited = 0; !models().document.hasCase() && waited < kPatienceMs; waited += 10)
      QTest::qWait(10);
    settle();
    if (!segmented) return;
    models().runs.run();
    state().setVolumeView(VolumeView::None);
    settle();
  }

  void settle() {
    QCoreApplication::processEvents();
    for (int plane = 0; plane < 3; ++plane) slice(plane)->grabFramebuffer();
    window->views().surface()->grabFramebuffer();
  }
  SliceView* slice(int plane) { return window->views().slice(plane); }
  CaseMeasures& measures() { return window->measures(); }
  const Measurement& last() { return measures().all().back(); }
  QTableWidget* table() { return find<QTableWidget>("measurements"); }
  QString value(int row) { return table()->item(row, 2)->text(); }
  QString notice() { return find<QLabel>("measureNotice")->text(); }
  QString details() { return find<QLabel>("measureDetails")->text(); }
  void trigger(const char* name) { test::trigger(*this, name); }
  Eigen::Vector3d inside(double share) { return insideOf(models(), share); }

  /// Clicks a place in the axial pane, at the slice that it lies in. @returns where
  Eigen::Vector3d clickSlice(const Eigen::Vector3d& lps) {
    window->views().setCrosshair(lps);
    const QPoint at = slice(2)->positionOf(lps).toPoint();
    QTest::mouseClick(slice(2), Qt::LeftButton, Qt::NoModifier, at);
    return slice(2)->lpsAt(at);
  }

  /// Drags what is under a place of a pane to another place, in two steps. @returns where to
  Eigen::Vector3d drag(SliceView* pane, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                       const std::function<void()>& underWay = {}) {
    const QPoint start = pane->positionOf(from).toPoint(), end = pane->positionOf(to).toPoint();
    QTest::mousePress(pane, Qt::LeftButton, Qt::NoModifier, start);
    QTest::mouseMove(pane, (start + end) / 2);
    QTest::mouseMove(pane, end);
    if (underWay) underWay();
    QTest::mouseRelease(pane, Qt::LeftButton, Qt::NoModifier, end);
    settle();
    return from + pane->lpsAt(end) - pane->lpsAt(start);
  }
};

}  // namespace

class TestMeasurements : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aDistanceIsTwoClicks() {
    MeasureCase c(twoTubes(), false);
    QTest::keyClick(c.window.get(), Qt::Key_F2, Qt::ShiftModifier);
    QVERIFY(c.state().tool() == Tool::MeasureDistance);
    QVERIFY(c.find<QToolButton>("toolDistanceButton")->isChecked());
    QVERIFY(!c.find<QToolButton>("toolSectionButton")->isEnabled());
    const Geometry& grid = c.models().document.image()->geometry;
    const Eigen::Vector3d from = c.clickSlice(grid.toPhysical({8.0, 12.0, 20.0}));
    QVERIFY(c.measures().all().empty());
    QVERIFY(c.notice().contains("other end"));
    const Eigen::Vector3d to = c.clickSlice(grid.toPhysical({30.0, 25.0, 20.0}));
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    QVERIFY((c.last().places[0] - from).norm() < 1e-9);
    QVERIFY((c.last().places[1] - to).norm() < 1e-9);
    QVERIFY(std::abs((to - from).norm() - 0.5 * std::hypot(22.0, 13.0)) < 0.3);
    QCOMPARE(c.table()->item(0, 0)->text(), QString("Distance 1"));
    QCOMPARE(c.value(0), QLocale().toString((to - from).norm(), 'f', 2) + " mm");
    QVERIFY(c.window->isWindowModified());
    QCOMPARE(c.models().document.undoStack()->undoText(), QString("measure a distance"));
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(c.table()->rowCount(), 0);
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(c.table()->rowCount(), 1);
    // Half a distance is forgotten with its tool.
    c.clickSlice(from);
    QCOMPARE(c.measures().picked().size(), std::size_t(1));
    QTest::keyClick(c.window.get(), Qt::Key_F2);
    QVERIFY(c.measures().picked().empty());
    c.clickSlice(to);
    QCOMPARE(c.table()->rowCount(), 1);
  }

  void aBandFollowsTheMouseWhilePlacesAreMissing() {
    MeasureCase c(twoTubes(), false);
    QTest::keyClick(c.window.get(), Qt::Key_F2, Qt::ShiftModifier);
    const Geometry& grid = c.models().document.image()->geometry;
    SliceView* pane = c.slice(2);
    const auto moved = [&](double i) {
      const QPoint at = pane->positionOf(grid.toPhysical({i, 25.0, 20.0})).toPoint();
      QTest::mouseMove(pane, at);
      QCoreApplication::processEvents();
      return pane->grabFramebuffer();
    };
    // Below the mouse in the middle between the two ends nothing but the band is.
    const auto middle = [&](const QImage& image) {
      const QPointF at =
          pane->positionOf(grid.toPhysical({18.0, 18.5, 20.0})) * pane->devicePixelRatioF();
      int changed = 0;
      static QImage before;
      for (int dy = -4; dy <= 4; ++dy)
        for (int dx = -4; dx <= 4; ++dx) {
          const QPoint p = at.toPoint() + QPoint(dx, dy);
          changed += !before.isNull() && before.pixel(p) != image.pixel(p);
        }
      before = image;
      return changed;
    };
    middle(moved(28.0));
    QCOMPARE(middle(moved(27.0)), 0);
    c.clickSlice(grid.toPhysical({8.0, 12.0, 20.0}));
    QVERIFY(middle(moved(28.0)) > 5);
    QVERIFY(middle(moved(10.0)) > 5);
    c.clickSlice(grid.toPhysical({30.0, 25.0, 20.0}));
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    middle(moved(28.0));
    QCOMPARE(middle(moved(10.0)), 0);
  }

  void anEndOfADistanceIsDragged() {
    MeasureCase c(twoTubes(), false);
    const Geometry& grid = c.models().document.image()->geometry;
    const auto at = [&](double i, double j) { return grid.toPhysical({i, j, 20.0}); };
    c.state().setTool(Tool::MeasureDistance);
    const Eigen::Vector3d from = c.clickSlice(at(8.0, 12.0)), to = c.clickSlice(at(30.0, 25.0));
    c.state().setTool(Tool::Navigate);
    c.settle();
    const auto [window, level] = c.state().windowLevel();
    const Eigen::Vector3d crosshair = c.window->views().crosshair();
    const QImage before = c.slice(2)->picture(1);
    const Eigen::Vector3d moved = c.drag(c.slice(2), to, at(12.0, 26.0), [&] {
      QVERIFY(c.slice(2)->picture(1) != before);
      QVERIFY((c.last().places[1] - to).norm() < 1e-9);
    });
    QVERIFY((moved - to).norm() > 5.0);
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    QVERIFY((c.last().places[0] - from).norm() < 1e-9);
    QVERIFY((c.last().places[1] - moved).norm() < 1e-9);
    QCOMPARE(c.value(0), QLocale().toString((moved - from).norm(), 'f', 2) + " mm");
    // Nothing else follows such a drag, and it is one edit.
    QCOMPARE(c.state().windowLevel(), std::pair(window, level));
    QVERIFY(c.window->views().crosshair() == crosshair);
    QCOMPARE(c.models().document.undoStack()->undoText(), QString("move Distance 1"));
    QTest::keyClick(c.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY((c.last().places[1] - to).norm() < 1e-9);
    c.settle();
    QCOMPARE(c.slice(2)->picture(1), before);
    // In a slice that does not show it, there is nothing to take hold of.
    c.slice(2)->setSlice(c.slice(2)->slice() + 5);
    c.drag(c.slice(2), to, at(12.0, 26.0));
    QVERIFY((c.last().places[1] - to).norm() < 1e-9);
    QVERIFY(c.state().windowLevel() != std::pair(window, level));
  }

  void whileTheToolMeasuresAnEndIsClickedOrDragged() {
    MeasureCase c(twoTubes(), false);
    const Geometry& grid = c.models().document.image()->geometry;
    const auto at = [&](double i, double j) { return grid.toPhysical({i, j, 20.0}); };
    c.state().setTool(Tool::MeasureDistance);
    c.clickSlice(at(8.0, 12.0));
    const Eigen::Vector3d to = c.clickSlice(at(30.0, 25.0));
    c.clickSlice(to);  // the next one begins where this one ends
    QCOMPARE(c.measures().picked().size(), std::size_t(1));
    c.clickSlice(at(30.0, 8.0));
    QCOMPARE(c.measures().all().size(), std::size_t(2));
    c.drag(c.slice(2), at(8.0, 12.0), at(10.0, 30.0));
    QCOMPARE(c.measures().all().size(), std::size_t(2));
    QVERIFY((c.measures().all()[0].places[0] - at(10.0, 30.0)).norm() < 0.5);
  }

  void aSectionIsDraggedAlongItsVessel() {
    MeasureCase c(narrowedTube());
    c.state().setTool(Tool::MeasureSection);
    c.clickSlice(c.inside(0.1));
    c.state().setTool(Tool::Navigate);
    c.settle();
    const CrossSection wide = c.last().sections.at(0);
    const Eigen::Vector3d place = c.last().places[0];
    const Geometry& grid = c.models().document.image()->geometry;
    Eigen::Vector3d narrow = grid.toIndex(place);
    narrow[2] = 27.5;
    c.drag(c.slice(1), place, grid.toPhysical(narrow));
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    QVERIFY2(c.last().sections.at(0).areaMm2 < 0.4 * wide.areaMm2, qPrintable(c.value(0)));
    // Off the vessel it is not measured, and goes back.
    const QImage before = c.slice(1)->picture(1);
    const Eigen::Vector3d there = c.last().places[0];
    Eigen::Vector3d outside = grid.toIndex(there);
    outside[0] = 3.0;
    c.drag(c.slice(1), there, grid.toPhysical(outside));
    QVERIFY2(c.notice().contains("there is no vessel"), qPrintable(c.notice()));
    QVERIFY((c.last().places[0] - there).norm() < 1e-9);
    QCOMPARE(c.slice(1)->picture(1), before);
  }

  void theMenuOfAPlaceMeasures() {
    MeasureCase c;
    const Eigen::Vector3d place = c.inside(0.5);
    c.window->views().setCrosshair(place);
    const QPoint at = c.slice(2)->positionOf(place).toPoint();
    const auto choose = [&](const char* name) {
      QTest::mouseClick(c.slice(2), Qt::RightButton, Qt::NoModifier, at);
      auto* action = c.window->findChild<QAction*>(name);
      QVERIFY(action && action->isEnabled());
      action->trigger();
      if (auto* menu = c.find<QMenu>("portMenu")) menu->close();
    };
    choose("toolSectionHere");
    QTRY_COMPARE(c.measures().all().size(), std::size_t(1));
    QVERIFY(c.last().kind == MeasurementKind::Section);
    QVERIFY((c.last().places[0] - place).norm() < 2.0);
    choose("toolDistanceHere");
    QVERIFY(c.state().tool() == Tool::MeasureDistance);
    QCOMPARE(c.measures().picked().size(), std::size_t(1));
  }

  void aSectionIsAClick() {
    MeasureCase c;
    QTest::keyClick(c.window.get(), Qt::Key_F3, Qt::ShiftModifier);
    c.clickSlice(c.inside(0.5));
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    const CrossSection slice = c.last().sections.at(0);
    QVERIFY2(std::abs(slice.equivalentDiameterMm() - 3.0) < 0.2, qPrintable(c.value(0)));
    QVERIFY(std::abs(slice.minDiameterMm() - 3.0) < 0.3);
    QVERIFY(
        c.value(0).contains(QLocale().toString(slice.areaMm2, 'f', 2) + QString::fromUtf8(" mm²")));
    // In 3D the click lies on the wall, and means the same vessel.
    SurfaceView* view = c.window->views().surface();
    QTest::mouseClick(view, Qt::LeftButton, Qt::NoModifier,
                      view->positionOf(slice.centreLps).toPoint());
    QCOMPARE(c.measures().all().size(), std::size_t(2));
    QVERIFY(std::abs(c.last().sections.at(0).areaMm2 - slice.areaMm2) < 0.5);
    // Off the vessels nothing is measured, and the panel says why.
    c.clickSlice(c.models().document.image()->geometry.toPhysical({3.0, 3.0, 20.0}));
    QCOMPARE(c.measures().all().size(), std::size_t(2));
    QVERIFY2(c.notice().contains("there is no vessel"), qPrintable(c.notice()));
    QCOMPARE(c.models().document.undoStack()->count(), 2);
  }

  void aStenosisComesWithItsFormulaAndPlot() {
    MeasureCase c(narrowedTube());
    QTest::keyClick(c.window.get(), Qt::Key_F5, Qt::ShiftModifier);
    QVERIFY(c.notice().contains("blood comes from"));
    c.clickSlice(c.inside(0.1));
    QVERIFY(c.notice().contains("behind the narrowing"));
    QVERIFY(!c.find<ProfilePlot>("profilePlot")->isVisible());
    c.clickSlice(c.inside(0.9));
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    const StenosisDegree degree = stenosisDegree(c.last());
    QVERIFY2(std::abs(degree.nascet - 0.5) < 0.06, qPrintable(c.value(0)));
    QVERIFY2(std::abs(degree.wasid - 0.5) < 0.06, qPrintable(c.value(0)));
    QVERIFY2(std::abs(degree.area - 0.75) < 0.06, qPrintable(c.value(0)));
    QVERIFY(c.value(0).contains(
        QString::fromUtf8("NASCET %1\u00a0%").arg(100.0 * degree.nascet, 0, 'f', 0)));
    QVERIFY2(c.details().contains(QString::fromUtf8("NASCET = 1 − D / D distal = 1 − ")),
             qPrintable(c.details()));
    QVERIFY(c.details().contains(QLocale().toString(c.last().sections[0].minDiameterMm(), 'f', 2)));
    const Geometry& grid = c.models().document.image()->geometry;
    const double slice = grid.toIndex(c.last().sections[0].centreLps)[2];
    QVERIFY2(std::abs(slice - 27.5) < 2.0, qPrintable(QString::number(slice)));
    // A click into the plot goes there, one on the row back to the narrowest place.
    auto* plot = c.find<ProfilePlot>("profilePlot");
    QVERIFY(plot->isVisible());
    const ProfilePoint& end = c.last().profile.front();
    QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, plot->positionOf(end).toPoint());
    QVERIFY((c.window->views().crosshair() - end.pointLps).norm() < 1.0);
    QTest::mouseClick(c.table()->viewport(), Qt::LeftButton, Qt::NoModifier,
                      c.table()->visualItemRect(c.table()->item(0, 1)).center());
    QVERIFY((c.window->views().crosshair() - c.last().sections[0].centreLps).norm() < 1e-6);
  }

  void aBranchIsShownFromEndToEnd() {
    MeasureCase c;
    QTest::keyClick(c.window.get(), Qt::Key_F4, Qt::ShiftModifier);
    c.clickSlice(c.inside(0.5));
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    QCOMPARE(c.table()->item(0, 0)->text(), QString("Branch 1"));
    const std::vector<ProfilePoint>& profile = c.last().profile;
    QVERIFY(profile.back().alongMm - profile.front().alongMm > 15.0);
    for (const ProfilePoint& point : profile) QVERIFY(std::abs(point.diameterMm - 3.0) < 0.4);
    QVERIFY(c.find<ProfilePlot>("profilePlot")->isVisible());
    c.trigger("toolNavigate");
    c.measures().select({});
    QVERIFY(!c.find<ProfilePlot>("profilePlot")->isVisible());
  }

  void measuresOfAnotherWallAreMarked() {
    MeasureCase c;
    c.state().setTool(Tool::MeasureSection);
    c.clickSlice(c.inside(0.5));
    const QString value = c.value(0);
    QVERIFY(!value.contains("earlier"));
    c.models().document.setField("segmentation.keep", std::string("largest"));
    QVERIFY(!c.value(0).contains("earlier"));  // the wall stays
    c.models().document.setField("levelset.xi", 60.0);
    QCOMPARE(c.value(0), value + QString::fromUtf8("\n⚠ of earlier parameters"));
    c.trigger("undo");
    QCOMPARE(c.value(0), value);
    c.trigger("redo");
    // What is measured on the wall that is still shown is of earlier parameters at once.
    c.clickSlice(c.inside(0.4));
    QVERIFY(c.value(1).contains("earlier"));
    c.models().runs.run();
    QVERIFY(c.value(0).contains("earlier") && c.value(1).contains("earlier"));
    const Measurement before = c.measures().all()[0];
    c.measures().select("Section 1");
    c.trigger("measureAgain");
    QVERIFY(!c.value(0).contains("earlier"));
    QVERIFY(c.value(1).contains("earlier"));
    QVERIFY(c.measures().all()[0].key != before.key);
    QCOMPARE(c.measures().all().size(), std::size_t(2));
    c.trigger("undo");
    QVERIFY(c.measures().all()[0] == before);
  }

  void namesAreEditedAndRowsDeleted() {
    MeasureCase c(twoTubes(), false);
    c.state().setTool(Tool::MeasureDistance);
    const Geometry& grid = c.models().document.image()->geometry;
    for (const double i : {8.0, 20.0, 12.0, 28.0}) c.clickSlice(grid.toPhysical({i, 12.0, 20.0}));
    QCOMPARE(c.table()->rowCount(), 2);
    QCOMPARE(c.measures().selected(), &c.last());
    c.trigger("renameMeasurement");
    auto* editor = c.table()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, "Distance 1");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(c.notice().contains("another measurement"));
    QCOMPARE(c.table()->item(1, 0)->text(), QString("Distance 2"));
    c.trigger("renameMeasurement");
    editor = c.table()->findChild<QLineEdit*>();
    editor->selectAll();
    QTest::keyClicks(editor, "Neck");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(c.last().name, std::string("Neck"));
    QCOMPARE(c.measures().selected(), &c.last());
    c.trigger("deleteMeasurement");
    QCOMPARE(c.table()->rowCount(), 1);
    QVERIFY(!c.find<QToolButton>("deleteMeasurementButton")->isEnabled());
    c.trigger("undo");
    QCOMPARE(c.table()->item(1, 0)->text(), QString("Neck"));
    c.trigger("undo");
    QCOMPARE(c.table()->item(1, 0)->text(), QString("Distance 2"));
  }

  void theyAreSavedWithTheCaseAndExported() {
    const Study study;
    std::vector<Measurement> measured;
    {
      WindowCase w;
      makeCase(w, study);
      w.models().runs.run();
      CaseMeasures& measures = w.window->measures();
      measures.pick(MeasurementKind::Profile, insideOf(w.models(), 0.5));
      const std::vector<ProfilePoint> along = measures.all().at(0).profile;
      measures.pick(MeasurementKind::Stenosis, along[along.size() / 4].pointLps);
      measures.pick(MeasurementKind::Stenosis, along[along.size() / 2].pointLps);
      measures.pick(MeasurementKind::Distance, {1.0, 2.0, 3.0});
      measures.pick(MeasurementKind::Distance, {4.0, 2.0, 3.0});
      measured = w.window->measures().all();
      QCOMPARE(measured.size(), std::size_t(3));
      test::trigger(w, "saveCase");
      QVERIFY(!w.window->isWindowModified());
    }
    WindowCase w;
    w.window->open(study.saved);
    QVERIFY(w.window->measures().all() == measured);
    QCOMPARE(w.find<QTableWidget>("measurements")->rowCount(), 3);
    QVERIFY(!w.window->measures().isEarlier(measured[0]));
    w.savePath = w.folder.filePath("table");
    test::trigger(w, "exportMeasurements");
    QFile file(w.folder.filePath("table.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().toStdString(),
             measurementsTable(measured, w.models().document.key(Step::Evolve)));
    QVERIFY(w.find<QPlainTextEdit>("log")->toPlainText().contains("Wrote table.csv: 3 measure"));
    w.savePath = w.folder.filePath("no/table.csv");
    test::trigger(w, "exportMeasurements");
    QVERIFY(w.find<QPlainTextEdit>("log")->toPlainText().contains("Cannot export"));
    // Another volume has none of them.
    w.window->open(study.otherVolume());
    QVERIFY(w.window->measures().all().empty());
    QCOMPARE(w.find<QTableWidget>("measurements")->rowCount(), 0);
  }

  void aWorkerMeasures() {
    MeasureCase c(narrowedTube(), false, makeThreadedJobRunner);
    c.models().runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().runs.running() && c.measures().ready(), kPatienceMs);
    c.measures().pick(MeasurementKind::Section, c.inside(0.5));
    c.measures().pick(MeasurementKind::Profile, c.inside(0.5));
    QVERIFY(c.measures().busy());
    QTRY_COMPARE_WITH_TIMEOUT(c.measures().all().size(), std::size_t(2), kPatienceMs);
  }

  /// Even if it has been measured when the case is left, and only not been looked at.
  void whatIsMeasuredOfACaseThatIsLeftIsDropped() {
    std::vector<HeldRunner*> runners;
    bool hold = false;
    MeasureCase c(twoTubes(), true, [&]() -> std::unique_ptr<JobRunner> {
      auto runner = std::make_unique<HeldRunner>(hold);
      runners.push_back(runner.get());
      return runner;
    });
    const Eigen::Vector3d place = c.inside(0.5);
    c.measures().pick(MeasurementKind::Section, place);
    QCOMPARE(c.measures().all().size(), std::size_t(1));
    hold = true;
    c.measures().pick(MeasurementKind::Section, place);
    QVERIFY(c.measures().busy());
    hold = false;
    c.models().files.take(twoTubes());
    QVERIFY(c.measures().all().empty());
    for (HeldRunner* runner : runners)
      if (runner->running()) runner->release();
    c.models().timer.poll();
    QVERIFY(!c.measures().busy());
    QVERIFY(c.measures().all().empty());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestMeasurements>(argc, argv); }
#include "tst_measurements.moc"

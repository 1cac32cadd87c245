// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>

#include "gui/pane/surface_feed.h"
#include "gui/panel/sensitivity_panel.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// A window with two tubes whose parameters were tried.
struct Tried : WindowCase {
  Tried() {
    models().live.setOn(false);
    models().files.take(twoTubes());
    click(find<QPushButton>("run"));
    click(find<QPushButton>("sensitivityStart"));
  }
  [[nodiscard]] std::shared_ptr<const TriMesh> shown() {
    return window->views().surfaceFeed()->shown();
  }
  QTableWidget& steps() { return *find<QTableWidget>("sensitivitySteps"); }
  QTableWidget& branches() { return *find<QTableWidget>("sensitivityBranches"); }
  QString note() { return find<QLabel>("sensitivityNote")->text(); }
  /// The row of a step of the table; -1: there is none.
  int rowOf(const QString& what) {
    for (int row = 0; row < steps().rowCount(); ++row)
      if (steps().item(row, 0)->text().startsWith(what)) return row;
    return -1;
  }
};

/// Of a cell, without its unit.
double numberIn(const QTableWidget& table, int row, int column) {
  const QString text = table.item(row, column)->text().replace(QStringLiteral("−"), "-");
  return text.section(' ', 0, 0).toDouble();
}

}  // namespace

/// What the parameters do to the wall, in the window.
class TestSensitivityWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(settings_.isValid());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
    tried_ = std::make_unique<Tried>();
  }
  void cleanupTestCase() { tried_.reset(); }

  void theTableIsThatOfTheLibrary() {
    Tried& c = *tried_;
    const auto mesh = c.models().results.mesh(MeshKind::Exported);
    QVERIFY(mesh);
    Pipeline pipeline(twoTubes());
    RunOptions options;
    options.until = Step::Correct;
    const Parameters params = c.models().document.parameters();
    const RunResult base = pipeline.run(params, options);
    const Sensitivity found =
        sensitivityOf(pipeline, params, parameterSteps(params, contextOf(base)));
    QCOMPARE(c.steps().rowCount(), static_cast<int>(found.effects.size()) + 1);
    for (const StepEffect& effect : found.effects) {
      if (!effect.why.empty()) continue;
      const int row = c.rowOf(CaseSensitivity::stepText(effect.step));
      QVERIFY2(row > 0, qPrintable(CaseSensitivity::stepText(effect.step)));
      QVERIFY(std::abs(numberIn(c.steps(), row, 1) - effect.moves.meanMm) < 6e-4);
      QVERIFY(std::abs(numberIn(c.steps(), row, 2) - effect.moves.p95Mm) < 6e-4);
      QVERIFY(std::abs(numberIn(c.steps(), row, 4) - effect.moves.volumePercent) < 6e-2);
    }
    QCOMPARE(c.branches().rowCount(), static_cast<int>(found.places.skeleton.branches.size()));
    // The case is as it was.
    QVERIFY(c.models().document.parameters() == params);
    QVERIFY(c.models().results.mesh(MeshKind::Exported) == mesh);
    QVERIFY(!c.models().document.undoStack()->canUndo());
  }

  void theWallIsPaintedInPlaceOfTheMesh() {
    Tried& c = *tried_;
    const auto& found = c.window->sensitivity().found();
    QVERIFY(found);
    QTRY_VERIFY(c.shown() == found->wall);
    auto* paint = c.find<QCheckBox>("sensitivityPaint");
    QVERIFY(paint->isChecked());
    c.click(paint);
    QTRY_VERIFY(c.shown() == c.models().results.mesh(MeshKind::Exported));
    c.click(paint);
    QTRY_VERIFY(c.shown() == found->wall);
    // Who chooses a mesh wants to see it.
    c.state().setMeshKind(MeshKind::MarchingCubes);
    QVERIFY(!paint->isChecked());
    QTRY_VERIFY(c.shown() == c.models().results.mesh(MeshKind::MarchingCubes));
    c.state().setMeshKind(MeshKind::Exported);
    QCOMPARE(found->spread.size(), found->wall->triangles.size());
    for (std::size_t n = 0; n < found->spread.size(); ++n)
      for (const std::uint32_t corner : found->wall->triangles[n])
        QVERIFY(found->spread[n] >= found->found.spreadMm[corner]);
  }

  void aRowPaintsItsStep() {
    Tried& c = *tried_;
    CaseSensitivity& sensitivity = c.window->sensitivity();
    QCOMPARE(sensitivity.chosen(), CaseSensitivity::kAll);
    const auto [red, blue] = sensitivity.scale();
    QVERIFY(red > 0.0 && blue == 0.0);
    c.steps().setCurrentCell(1, 0);
    QVERIFY(sensitivity.chosen() != CaseSensitivity::kAll);
    const StepEffect& effect =
        sensitivity.found()->found.effects[static_cast<std::size_t>(sensitivity.chosen())];
    QCOMPARE(c.steps().item(1, 0)->text(), CaseSensitivity::stepText(effect.step));
    QVERIFY(sensitivity.title().contains(CaseSensitivity::stepText(effect.step)));
    QCOMPARE(sensitivity.scale()[0], -red);
    QCOMPARE(sensitivity.scale()[1], red);
    // The first row after "all" is the one that moves the wall most.
    for (const StepEffect& other : sensitivity.found()->found.effects)
      QVERIFY(other.moves.meanSizeMm <= effect.moves.meanSizeMm);
    // Of a triangle the mean of its corners, of a branch what this step does.
    const auto& triangle = sensitivity.found()->wall->triangles[0];
    double mean = 0.0;
    for (const std::uint32_t corner : triangle) mean += effect.moves.movedMm[corner] / 3.0;
    QVERIFY(std::abs(sensitivity.values()[0] - mean) < 1e-5);
    const auto branch =
        static_cast<std::size_t>(c.branches().item(0, 0)->data(Qt::UserRole).toInt());
    QVERIFY(std::abs(numberIn(c.branches(), 0, 3) - effect.moves.branches[branch].meanMm) < 6e-4);
    c.steps().setCurrentCell(0, 0);
    QCOMPARE(sensitivity.chosen(), CaseSensitivity::kAll);
  }

  void aBranchIsGoneTo() {
    Tried& c = *tried_;
    c.branches().setCurrentCell(-1, -1);
    const Eigen::Vector3d before = c.window->views().crosshair();
    c.branches().setCurrentCell(0, 0);
    const auto branch =
        static_cast<std::size_t>(c.branches().item(0, 0)->data(Qt::UserRole).toInt());
    const SkeletonBranch& longest =
        c.window->sensitivity().found()->found.places.skeleton.branches[branch];
    QVERIFY((c.window->views().crosshair() - before).norm() > 0.1);
    QVERIFY((c.window->views().crosshair() - longest.points[longest.points.size() / 2].pointLps)
                .norm() < 1e-6);
    for (int row = 1; row < c.branches().rowCount(); ++row)
      QVERIFY(numberIn(c.branches(), row, 1) <= numberIn(c.branches(), row - 1, 1));
  }

  void itSaysWhoseItIs() {
    Tried& c = *tried_;
    CaseSensitivity& sensitivity = c.window->sensitivity();
    QVERIFY(!sensitivity.stale());
    const QString fresh = c.note();
    c.models().document.setField("levelset.xi", 26.0);
    QVERIFY(sensitivity.stale());
    QVERIFY(c.note() != fresh);
    c.models().document.undoStack()->undo();
    QVERIFY(!sensitivity.stale());
    // What is made of the segmentation is no parameter of the wall's.
    c.models().document.setField("surface.rho", 0.3);
    QVERIFY(!sensitivity.stale());
    c.models().files.take(twoTubes(36));
    QVERIFY(!sensitivity.found());
    QCOMPARE(c.steps().rowCount(), 0);
    QVERIFY(!c.find<QCheckBox>("sensitivityPaint")->isEnabled());
  }

  void itCanBeCancelled() {
    WindowCase c(makeThreadedJobRunner);
    c.models().live.setOn(false);
    auto* start = c.find<QPushButton>("sensitivityStart");
    QVERIFY(!start->isEnabled());
    c.models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    QVERIFY(start->isEnabled());
    c.window->findChild<QAction*>("trySensitivity")->trigger();
    QVERIFY(c.window->sensitivity().busy());
    QVERIFY(!c.window->findChild<QAction*>("trySensitivity")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(c.window->sensitivity().fraction() > 0.0, kPatienceMs);
    c.window->findChild<QAction*>("cancelRun")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!c.window->sensitivity().busy(), kPatienceMs);
    QVERIFY(!c.window->sensitivity().found());
    QVERIFY(start->isEnabled());
  }

 private:
  QTemporaryDir settings_;
  std::unique_ptr<Tried> tried_;
};

QTEST_MAIN(TestSensitivityWindow)
#include "tst_sensitivity_window.moc"

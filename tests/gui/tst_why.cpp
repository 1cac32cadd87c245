// SPDX-License-Identifier: BSD-3-Clause
#include <QDockWidget>
#include <QLabel>
#include <QMenu>

#include "window_case.h"

using namespace angiomesh;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

/// The panel that tells why the voxel under the crosshair is vessel or not.
class TestWhy : public QObject {
  Q_OBJECT

 private:
  static QString sentence(WindowCase& c) { return c.find<QLabel>("whySentence")->text(); }

 private Q_SLOTS:
  void itFollowsTheCrosshairAndTheResults() {
    WindowCase c;
    auto* dock = c.find<QDockWidget>("whyDock");
    dock->show();
    dock->raise();
    QTRY_VERIFY(c.find<QLabel>("whySentence")->isVisible());
    QCOMPARE(sentence(c), QString("Open a volume first."));
    c.models().files.take(twoTubes());
    QVERIFY2(sentence(c).startsWith("Run to Evolve"), qPrintable(sentence(c)));
    c.models().runs.run();
    const SegmentComponent& part = c.models().results.meshRun()->surface->components.front();
    c.window->views().setCrosshair(part.innerPointLps);
    QVERIFY2(sentence(c).startsWith("Inside: "), qPrintable(sentence(c)));
    for (int i = 0; i < 9; ++i)
      QVERIFY(!c.find<QLabel>(QStringLiteral("why%1").arg(i))->text().isEmpty());
    QVERIFY(c.find<QLabel>("why1")->text().startsWith('-'));
    // Shift and the moving mouse take the crosshair out of the vessel.
    SliceView* axial = c.window->views().slice(2);
    const Geometry& grid = c.models().document.image()->geometry;
    const QPoint corner = axial->positionOf(grid.toPhysical({3.0, 3.0, 20.0})).toPoint();
    test::sendMouse(*axial, QEvent::MouseMove, corner, Qt::NoButton, Qt::NoButton,
                    Qt::ShiftModifier);
    QVERIFY2(sentence(c).startsWith("Outside: "), qPrintable(sentence(c)));
    // A part that is ticked off.
    c.models().results.setComponentTicked(0, false);
    c.models().runs.run();
    c.window->views().setCrosshair(part.innerPointLps);
    QVERIFY2(sentence(c).contains("left out"), qPrintable(sentence(c)));
    // Vesselness that the segmentation was not made of gives no reasons.
    c.models().document.setField("vesselness.alpha", 0.6);
    c.models().runs.run(Step::Vesselness);
    QVERIFY2(sentence(c).startsWith("Run to Evolve"), qPrintable(sentence(c)));
    QVERIFY(c.find<QLabel>("why3")->text().isEmpty());
  }

  void theMenuOfASliceAsks() {
    WindowCase c;
    c.models().files.take(twoTubes());
    c.models().runs.run(Step::Evolve);
    c.find<QDockWidget>("whyDock")->hide();
    SliceView* axial = c.window->views().slice(2);
    const Geometry& grid = c.models().document.image()->geometry;
    const QPoint corner = axial->positionOf(grid.toPhysical({3.0, 3.0, 20.0})).toPoint();
    QTest::mouseClick(axial, Qt::RightButton, Qt::NoModifier, corner);
    auto* menu = c.find<QMenu>("portMenu");
    QVERIFY(menu);
    for (QAction* action : menu->actions())
      if (action->text() == "Why here?") action->trigger();
    QVERIFY(c.find<QDockWidget>("whyDock")->isVisible());
    QVERIFY2(sentence(c).startsWith("Outside: "), qPrintable(sentence(c)));
  }

  void itAnswersWhileTheCrosshairMoves() {
    WindowCase c(makeThreadedJobRunner);
    auto* dock = c.find<QDockWidget>("whyDock");
    dock->show();
    dock->raise();
    c.models().files.take(twoTubes());
    QTRY_VERIFY(c.models().document.hasCase());
    c.models().runs.run(Step::Evolve);
    // Nothing else makes it look again.
    QTRY_VERIFY_WITH_TIMEOUT(!c.models().busy(), test::kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!c.find<QLabel>("why0")->text().isEmpty(), test::kPatienceMs);
    const Geometry& g = c.models().document.image()->geometry;
    for (int i = 0; i < 20; ++i) c.window->views().setCrosshair(g.toPhysical({1.0 * i, 2.0, 3.0}));
    const QString last = QStringLiteral("voxel 19,2,3");
    QTRY_VERIFY_WITH_TIMEOUT(c.find<QLabel>("why0")->text().startsWith(last), test::kPatienceMs);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestWhy>(argc, argv); }
#include "tst_why.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>

#include "gui/findings/mesh_inspection.h"
#include "gui/view/mesh_chooser.h"
#include "io/mesh/mesh_io.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// A window after a run of two tubes, with a wide 3D pane.
struct Split : WindowCase {
  Split() {
    models().files.take(twoTubes());
    click(find<QPushButton>("run"));
    state().setVolumeView(VolumeView::None);
    window->views().setLargePane(shown());
    window->views().setPaneLayout(PaneLayout::Single);
    for (auto* dock : window->findChildren<QDockWidget*>())
      dock->setVisible(dock->objectName() == "inspectorDock");
    (void)QTest::qWaitFor(
        [this] { return shown()->width() > 600 && find<QWidget>("meshChooser")->isVisible(); });
  }
  SurfaceView* shown() { return window->views().surface(); }
  SurfaceView* beside() { return window->views().comparison(); }
  QSplitter* pane() { return find<QSplitter>("pane3d"); }
  /// By the button in the pane.
  bool split() {
    click(find<QToolButton>("paneSplit"));
    return QTest::qWaitFor([this] {
      return beside()->isVisible() && pane()->handle(1)->x() > 0 &&
             std::abs(beside()->width() - shown()->width()) < 3;
    });
  }
};

/// Where a place lies in a view, from its middle.
QPointF fromMiddle(const SurfaceView& view, const Eigen::Vector3d& lps) {
  return view.positionOf(lps) - QRectF(view.rect()).center();
}

/// A bar goes along, and its coordinates with it.
void dragBy(QWidget& bar, int right) {
  const QPoint middle = bar.rect().center();
  sendMouse(bar, QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::LeftButton);
  sendMouse(bar, QEvent::MouseMove, middle + QPoint(right, 0), Qt::NoButton, Qt::LeftButton);
  sendMouse(bar, QEvent::MouseButtonRelease, middle, Qt::LeftButton, Qt::NoButton);
}

bool alike(const SurfaceView& a, const SurfaceView& b) {
  for (const Eigen::Vector3d& lps :
       {Eigen::Vector3d(2.0, 3.0, 4.0), Eigen::Vector3d(15.0, 9.0, 1.0)})
    if ((fromMiddle(a, lps) - fromMiddle(b, lps)).manhattanLength() > 1.0) return false;
  return true;
}

}  // namespace

class TestSplit : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBarDividesThePane() {
    Split c;
    QVERIFY(c.beside()->isHidden());
    QVERIFY(c.split());
    QVERIFY(c.find<QCheckBox>("comparison")->isChecked());
    QWidget* bar = c.pane()->handle(1);
    const int before = c.shown()->width();
    (void)c.shown()->grabFramebuffer();  // fitted to its half
    const QPointF size = fromMiddle(*c.shown(), {2.0, 3.0, 4.0});
    dragBy(*bar, -120);
    QTRY_COMPARE(c.shown()->width(), before - 120);
    QCOMPARE(c.beside()->width() + c.shown()->width() + bar->width(), c.pane()->width());
    // What is in the middle stays in the middle, as large as it was.
    QTRY_VERIFY(alike(*c.shown(), *c.beside()));
    (void)c.shown()->grabFramebuffer();
    QVERIFY((fromMiddle(*c.shown(), {2.0, 3.0, 4.0}) - size).manhattanLength() < 1.0);
    QVERIFY(alike(*c.shown(), *c.beside()));
    // Neither goes away.
    dragBy(*bar, -5000);
    QVERIFY(c.shown()->width() >= 80);
    c.click(c.find<QToolButton>("paneSplit"));
    QTRY_VERIFY(c.beside()->isHidden() && c.shown()->width() == c.pane()->width());
  }

  void camerasAreLinked() {
    Split c;
    QVERIFY(c.split());
    QTRY_VERIFY(alike(*c.shown(), *c.beside()));
    const auto turn = [](SurfaceView* view) {
      const QPoint middle = view->rect().center();
      test::drag(*view, Qt::LeftButton, middle, middle + QPoint(60, 25));
    };
    const QPointF before = fromMiddle(*c.shown(), {2.0, 3.0, 4.0});
    for (SurfaceView* view : {c.shown(), c.beside()}) {
      turn(view);
      QVERIFY((fromMiddle(*c.shown(), {2.0, 3.0, 4.0}) - before).manhattanLength() > 5.0);
      QVERIFY(alike(*c.shown(), *c.beside()));
    }
    auto* linked = c.find<QToolButton>("paneLinked");
    QVERIFY(linked->isVisible() && linked->isChecked());
    c.click(linked);
    turn(c.beside());
    QVERIFY(!alike(*c.shown(), *c.beside()));
    QTest::keyClick(c.shown(), Qt::Key_Up);
    QVERIFY(!alike(*c.shown(), *c.beside()));
    // Linked again, the second one looks where the first one does.
    const QPointF first = fromMiddle(*c.shown(), {2.0, 3.0, 4.0});
    c.click(linked);
    QVERIFY(alike(*c.shown(), *c.beside()));
    QCOMPARE(fromMiddle(*c.shown(), {2.0, 3.0, 4.0}), first);
    // A case knows.
    c.click(linked);
    const CaseView kept = c.state().caseView();
    c.click(linked);
    c.state().take(kept);
    QVERIFY(!c.state().linked() && !linked->isChecked());
  }

  void eachViewHasItsMesh() {
    Split c;
    QVERIFY(c.split());
    // Told apart by the colours of their triangles.
    c.state().setMeshColour(&triangleMeasures().front());
    c.choose(c.find<QComboBox>("paneMesh"), static_cast<int>(MeshKind::MarchingCubes));
    QCOMPARE(c.find<QComboBox>("meshShown")->currentIndex(),
             static_cast<int>(MeshKind::MarchingCubes));
    // The same mesh twice, but for the letters of the ports and of the caption.
    const auto middle = [](SurfaceView* view) {
      return view->grabFramebuffer().copy(view->width() / 4, view->height() / 3, view->width() / 2,
                                          view->height() / 3);
    };
    QTRY_VERIFY(middle(c.shown()) == middle(c.beside()));
    auto* other = c.find<QComboBox>("paneBeside");
    c.choose(other, static_cast<int>(MeshKind::Exported));
    QVERIFY(c.state().besideKind() == MeshKind::Exported);
    QTRY_VERIFY(middle(c.shown()) != middle(c.beside()));
    c.choose(c.find<QComboBox>("meshBeside"), static_cast<int>(MeshKind::MarchingCubes));
    QCOMPARE(other->currentIndex(), static_cast<int>(MeshKind::MarchingCubes));
    // One from a file can be chosen once there is one.
    c.choose(other, static_cast<int>(MeshKind::File));
    QVERIFY(c.state().besideKind() != MeshKind::File);
    c.openPath = c.folder.filePath("cubes.ply");
    (void)writeMesh(*c.models().results.mesh(MeshKind::MarchingCubes), c.openPath.toStdString());
    trigger(c, "openMesh");
    c.choose(other, static_cast<int>(MeshKind::File));
    QVERIFY(c.state().besideKind() == MeshKind::File);
    c.choose(c.find<QComboBox>("paneMesh"), static_cast<int>(MeshKind::MarchingCubes));
    QTRY_VERIFY(middle(c.shown()) == middle(c.beside()));
    // It goes with the case.
    c.models().files.take(slowTree());
    QVERIFY(c.state().besideKind() == MeshKind::MarchingCubes);
    QVERIFY(c.find<QWidget>("meshChooser")->isHidden());
  }
};

int main(int argc, char** argv) { return runWindowTests<TestSplit>(argc, argv); }
#include "tst_split.moc"

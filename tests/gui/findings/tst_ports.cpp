// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>
#include <cmath>

#include "tests/gui/port_case.h"

using namespace angiomesh;
using angiomesh::test::coil;
using angiomesh::test::cutAt;
using angiomesh::test::kPatienceMs;
using angiomesh::test::PortCase;
using angiomesh::test::sendMouse;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

QString noteOf(PortCase& c, const char* name) {
  const PortRow* row = c.ports().find(name);
  return row ? row->note : QString();
}

}  // namespace

class TestPorts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theShortcutCutsAtTheCrosshair() {
    PortCase c;
    QCOMPARE(c.cuts(), std::size_t(0));
    const auto openings = c.table()->rowCount();
    QVERIFY(openings >= 2);
    QVERIFY(c.table()->item(0, 0)->text().startsWith("border_"));
    c.window->views().setCrosshair(c.inside());
    const int before = c.undoCount();
    QTest::keyClick(c.window.get(), Qt::Key_K, Qt::ControlModifier);
    QCOMPARE(c.cuts(), std::size_t(1));
    QCOMPARE(c.undoCount(), before + 1);
    QCOMPARE(c.cut(0).name, std::string("inlet"));
    QVERIFY((c.cut(0).pointLps - c.inside()).norm() < 1.0);
    const PortRow* row = c.ports().selected();
    QVERIFY(row && row->cut && row->name == "inlet");
    QVERIFY2(row->state == PortRow::State::Good || row->state == PortRow::State::Advised,
             qPrintable(row->note));
    QVERIFY2(std::abs(row->diameterMm() - 3.0) < 0.3,
             qPrintable(QString::number(row->diameterMm())));
    QVERIFY(c.models().runs.state(Step::Surface) == StepState::Stale);
    QVERIFY(c.find<QLabel>("summary", "field:ports.cuts")->text().contains("1"));
    c.cutAt(0.25);
    QCOMPARE(c.cut(1).name, std::string("outlet"));
    c.undo();
    QCOMPARE(c.cuts(), std::size_t(1));
    c.undo();
    QCOMPARE(c.cuts(), std::size_t(0));
    c.redo();
    c.redo();
    QCOMPARE(c.cuts(), std::size_t(2));
    QCOMPARE(c.table()->item(1, 0)->text(), QString("outlet"));
    QTest::mouseClick(c.find<QPushButton>("clear", "field:ports.cuts"), Qt::LeftButton);
    QCOMPARE(c.cuts(), std::size_t(0));
  }

  void theKeysAreListed() {
    WindowCase c;
    QVERIFY(!c.find<QToolButton>("cutHereButton")->isEnabled());
    QVERIFY(c.find<QLabel>("portNotice")->text().contains("Run to Evolve"));
    QTest::keyClick(c.window.get(), Qt::Key_F1);
    QTRY_VERIFY(c.find<QTableWidget>("shortcutsTable"));
    auto* table = c.find<QTableWidget>("shortcutsTable");
    for (const char* text : {"Cut here", "Cut all ends…", "Cut across", "Cut all across", "Flip",
                             "Rename", "Delete", "Import ports…", "Export ports…", "Cut vessel"})
      QCOMPARE(table->findItems(QString::fromUtf8(text), Qt::MatchExactly).size(), 1);
  }

  void aClickIn3dCuts() {
    PortCase c;
    const QPoint at = c.view()->positionOf(c.inside()).toPoint();
    c.rightClick(c.view(), at);
    auto* menu = c.find<QMenu>("portMenu");
    QVERIFY(menu);
    QCOMPARE(menu->actions().front()->text(), QString("Cut here"));
    menu->actions().front()->trigger();
    menu->close();
    QCOMPARE(c.cuts(), std::size_t(1));
    QVERIFY((c.cut(0).pointLps - c.inside()).norm() < 1.5);
    // The tool does the same with the left button, and goes back to turning the view.
    c.undo();
    QTest::keyClick(c.window.get(), Qt::Key_F9);
    QVERIFY(c.state().tool() == Tool::CutVessel);
    QTest::mouseClick(c.view(), Qt::LeftButton, Qt::NoModifier, at);
    QCOMPARE(c.cuts(), std::size_t(1));
    QVERIFY(c.state().tool() == Tool::Navigate);
  }

  void aClickInASliceCuts() {
    PortCase c;
    const Eigen::Vector3d place = c.inside();
    c.window->views().setCrosshair(place);
    SliceView* slice = c.window->views().slice(2);
    slice->grabFramebuffer();
    const QPoint at = slice->positionOf(place).toPoint();
    c.rightClick(slice, at);
    auto* menu = c.find<QMenu>("portMenu");
    QVERIFY(menu);
    menu->actions().front()->trigger();
    menu->close();
    QCOMPARE(c.cuts(), std::size_t(1));
    c.undo();
    c.state().setTool(Tool::CutVessel);
    QTest::mouseClick(slice, Qt::LeftButton, Qt::NoModifier, at);
    QCOMPARE(c.cuts(), std::size_t(1));
    // A drag of the right button zooms as ever, and asks for nothing.
    QTest::mousePress(slice, Qt::RightButton, Qt::NoModifier, at);
    QTest::mouseMove(slice, at + QPoint(0, 20));
    QTest::mouseRelease(slice, Qt::RightButton, Qt::NoModifier, at + QPoint(0, 20));
    QVERIFY(!c.find<QMenu>("portMenu") || !c.find<QMenu>("portMenu")->isVisible());
  }

  void offTheVesselsNothingIsCut() {
    PortCase c;
    c.window->views().setCrosshair(
        c.models().document.image()->geometry.toPhysical({1.0, 1.0, 20.0}));
    c.trigger("cutHere");
    QCOMPARE(c.cuts(), std::size_t(0));
    QVERIFY(c.find<QLabel>("portNotice")->text().contains("no vessel"));
  }

  void theDiscIsDraggedAndTilted() {
    PortCase c;
    c.cutAt(0.5);
    c.settle();
    const CutPlane before = c.ports().selected()->plane;
    const GivenCut given = c.cut(0);
    const int undos = c.undoCount();
    const QPoint centre = c.view()->positionOf(before.pointLps).toPoint();
    const QPoint tip = c.view()->arrowTipOf("inlet").toPoint();
    const auto key = c.models().document.parameters().ports.cuts;

    // Along the vessel, away from the arrow.
    const QPointF away =
        QPointF(centre - tip) / std::hypot(centre.x() - tip.x(), centre.y() - tip.y());
    QTest::mousePress(c.view(), Qt::LeftButton, Qt::NoModifier, centre);
    for (int i = 1; i <= 5; ++i) {
      sendMouse(*c.view(), QEvent::MouseMove, (centre + 6.0 * i * away).toPoint(), Qt::NoButton,
                Qt::LeftButton);
    }
    QVERIFY(c.ports().dragging());
    QVERIFY(c.models().document.parameters().ports.cuts == key);
    QTest::mouseRelease(c.view(), Qt::LeftButton, Qt::NoModifier, (centre + 30.0 * away).toPoint());
    QCOMPARE(c.undoCount(), undos + 1);
    QCOMPARE(c.models().document.undoStack()->undoText(), QString("move the cut inlet"));
    const Eigen::Vector3d moved = c.cut(0).pointLps - given.pointLps;
    QVERIFY2(moved.dot(before.normalLps) < -0.8, qPrintable(QString::number(moved.norm())));
    QVERIFY(moved.cross(before.normalLps).norm() < 0.5);
    QVERIFY(c.ports().selected()->state != PortRow::State::Impossible);
    c.undo();
    QVERIFY(c.models().document.parameters().ports.cuts == key);
    c.redo();

    c.settle();
    const GivenCut there = c.cut(0);
    const QPoint now = c.view()->arrowTipOf("inlet").toPoint();
    const QPoint aside = now + QPoint(14, 0);
    c.drag(c.view(), now, aside);
    QCOMPARE(c.undoCount(), undos + 2);
    QCOMPARE(c.models().document.undoStack()->undoText(), QString("tilt the cut inlet"));
    const double cosine = c.cut(0).normalLps->normalized().dot(there.normalLps->normalized());
    QVERIFY2(cosine < 0.985 && cosine > 0.3, qPrintable(QString::number(cosine)));
    QVERIFY((c.cut(0).pointLps - there.pointLps).norm() < 0.3);
    c.undo();
    QVERIFY((*c.cut(0).normalLps - *there.normalLps).norm() < 1e-9);

    // A press without a way selects, and edits nothing.
    c.settle();
    const int count = c.undoCount();
    c.ports().select({});
    QTest::mouseClick(c.view(), Qt::LeftButton, Qt::NoModifier,
                      c.view()->positionOf(c.ports().find("inlet")->plane.pointLps).toPoint());
    QVERIFY(c.ports().selected());
    QCOMPARE(c.undoCount(), count);
  }

  void theDiscIsDraggedAndTurnedInSlices() {
    PortCase c;
    c.cutAt(0.5);
    c.ports().visit("inlet");
    const GivenCut given = c.cut(0);
    const Eigen::Vector3d normal = given.normalLps->normalized();
    const int undos = c.undoCount();
    const auto key = c.models().document.parameters().ports.cuts;
    SliceView* slice = c.window->views().slice(1);
    slice->grabFramebuffer();
    const QPointF centre = slice->positionOf(given.pointLps);
    const QPointF ahead = slice->positionOf(given.pointLps - 2.5 * normal);

    // Along the vessel, away from the arrow: the panes go where the disc goes.
    QSignalSpy contrast(slice, &SliceView::windowLevelChanged);
    c.ports().select({});
    c.drag(slice, centre.toPoint(), ahead.toPoint());
    QCOMPARE(c.undoCount(), undos + 1);
    QCOMPARE(c.models().document.undoStack()->undoText(), QString("move the cut inlet"));
    QVERIFY(c.ports().selected() && c.ports().selected()->name == "inlet");
    QVERIFY(contrast.isEmpty());
    const Eigen::Vector3d moved = c.cut(0).pointLps - given.pointLps;
    QVERIFY2(std::abs(moved.dot(normal) + 2.5) < 0.5, qPrintable(QString::number(moved.norm())));
    QVERIFY(moved.cross(normal).norm() < 0.5);
    QVERIFY((c.window->views().crosshair() - c.cut(0).pointLps).norm() < 0.01);
    c.undo();
    QVERIFY(c.models().document.parameters().ports.cuts == key);

    // By its arrow about its centre, in the plane of the slice.
    slice->grabFramebuffer();
    const double length = 1.3 * c.ports().selected()->radiusMm;
    const Eigen::Vector3d aside = Eigen::Vector3d::UnitY().cross(normal);
    const Eigen::Vector3d wanted = (normal + 0.5 * aside).normalized();
    c.drag(slice, slice->positionOf(given.pointLps + length * normal).toPoint(),
           slice->positionOf(given.pointLps + length * wanted).toPoint());
    QCOMPARE(c.undoCount(), undos + 1);
    QCOMPARE(c.models().document.undoStack()->undoText(), QString("tilt the cut inlet"));
    QVERIFY(c.cut(0).normalLps->normalized().dot(wanted) > 0.98);
    // Written to micrometres.
    QVERIFY((c.cut(0).pointLps - given.pointLps).norm() < 2e-3);
    c.undo();

    // Pressed without a way it is selected alone; Ctrl and other tools leave it where it is.
    slice->grabFramebuffer();
    c.ports().select({});
    QTest::mouseClick(slice, Qt::LeftButton, Qt::NoModifier, centre.toPoint());
    QVERIFY(c.ports().selected());
    QVERIFY(c.models().document.parameters().ports.cuts == key);
    test::drag(*slice, Qt::LeftButton, centre.toPoint(), ahead.toPoint(), Qt::ControlModifier);
    QVERIFY(!contrast.isEmpty());
    QVERIFY(c.models().document.parameters().ports.cuts == key);
    contrast.clear();
    c.state().setTool(Tool::PickSeed);
    c.drag(slice, centre.toPoint(), ahead.toPoint());
    QVERIFY(!contrast.isEmpty());
    QVERIFY(c.models().document.parameters().ports.cuts == key);
    c.state().setTool(Tool::Navigate);

    // The tool changes while it is held: it can still be dropped.
    QTest::mousePress(slice, Qt::LeftButton, Qt::NoModifier, centre.toPoint());
    sendMouse(*slice, QEvent::MouseMove, ahead.toPoint(), Qt::NoButton, Qt::LeftButton);
    QVERIFY(c.ports().dragging());
    c.state().setTool(Tool::DrawRoi);
    QTest::mouseRelease(slice, Qt::LeftButton, Qt::NoModifier, ahead.toPoint());
    QVERIFY(!c.ports().dragging());
    QVERIFY(c.models().document.parameters().ports.cuts != key);
    c.state().setTool(Tool::Navigate);
    c.undo();

    // A right click on it offers what can be done with it.
    c.window->views().setCrosshair(given.pointLps);
    slice->grabFramebuffer();
    c.rightClick(slice, centre.toPoint());
    auto* menu = c.find<QMenu>("portMenu");
    QVERIFY(menu && menu->actions().contains(c.window->findChild<QAction*>("flipPort")));
    menu->close();
  }

  void theDiscFollowsItsVesselOutOfTheSlice() {
    PortCase c({}, coil());
    c.cutAt(0.5);
    c.ports().visit("inlet");
    const Eigen::Vector3d from = c.cut(0).pointLps;
    SliceView* slice = c.window->views().slice(2);
    slice->grabFramebuffer();
    const int before = slice->slice();
    // Round the coil's axis, which rises.
    const Geometry& g = c.models().document.image()->geometry;
    const Eigen::Vector3d middle = g.toPhysical({21.5, 21.5, 21.5});
    const auto rotated = [&](double angle) {
      const Eigen::Vector3d arm = from - middle;
      return Eigen::Vector3d(middle + Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * arm);
    };
    QTest::mousePress(slice, Qt::LeftButton, Qt::NoModifier, slice->positionOf(from).toPoint());
    for (int k = 1; k <= 12; ++k) {
      const QPoint at = slice->positionOf(rotated(0.1 * k)).toPoint();
      sendMouse(*slice, QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton);
    }
    QVERIFY(c.ports().dragging());
    QVERIFY(slice->slice() != before);
    QTest::mouseRelease(slice, Qt::LeftButton, Qt::NoModifier,
                        slice->positionOf(rotated(1.2)).toPoint());
    const Eigen::Vector3d there = c.cut(0).pointLps;
    QVERIFY((there - rotated(1.2)).head<2>().norm() < 1.0);
    QVERIFY(std::abs(there.z() - from.z()) > 1.0);
    QVERIFY(c.ports().selected()->state != PortRow::State::Impossible);
    QCOMPARE(slice->slice(), static_cast<int>(std::round(g.toIndex(there)[2])));
  }

  void aDragElsewhereTurnsTheView() {
    PortCase c;
    c.cutAt(0.5);
    c.settle();
    QSignalSpy turned(c.view(), &SurfaceView::cameraMoved);
    c.drag(c.view(), {8, 60}, {60, 90});
    QVERIFY(!turned.isEmpty());
    QVERIFY(!c.ports().dragging());
  }

  void flipsRenamesAndDeletes() {
    PortCase c;
    c.cutAt(0.5);
    const Eigen::Vector3d normal = *c.cut(0).normalLps;
    c.click(c.find<QToolButton>("flipPortButton"));
    QVERIFY((*c.cut(0).normalLps + normal).norm() < 1e-3);
    c.undo();
    QVERIFY((*c.cut(0).normalLps - normal).norm() < 1e-9);

    const auto rename = [&](const QString& name) {
      c.table()->setFocus();
      c.trigger("renamePort");
      auto* editor = c.table()->findChild<QLineEdit*>();
      QVERIFY(editor);
      editor->setText(name);
      QTest::keyClick(editor, Qt::Key_Return);
      QCoreApplication::processEvents();
    };
    rename("bad name");
    QCOMPARE(c.cut(0).name, std::string("inlet"));
    QTRY_COMPARE(c.table()->item(0, 0)->text(), QString("inlet"));
    const QString why = c.find<QLabel>("portNotice")->text();
    QVERIFY2(why.contains("'bad name' is no name for a port"), qPrintable(why));
    for (const char* name : {"wall", "border_3", "a,b", ""}) {
      rename(name);
      QCOMPARE(c.cut(0).name, std::string("inlet"));
    }
    rename("aorta-in");
    QTRY_COMPARE(c.cut(0).name, std::string("aorta-in"));
    QCOMPARE(c.cut(0).name, std::string("aorta-in"));
    QVERIFY(c.ports().selected() && c.ports().selected()->name == "aorta-in");
    QVERIFY(c.find<QLabel>("portNotice")->text().isEmpty());
    c.undo();
    QCOMPARE(c.cut(0).name, std::string("inlet"));
    c.redo();
    QCOMPARE(c.table()->item(0, 0)->text(), QString("aorta-in"));

    c.ports().select("aorta-in");
    c.click(c.find<QToolButton>("deletePortButton"));
    QCOMPARE(c.cuts(), std::size_t(0));
    c.undo();
    QCOMPARE(c.cuts(), std::size_t(1));
    c.redo();
    QCOMPARE(c.cuts(), std::size_t(0));
  }

  void aColourStaysWithItsPort() {
    PortCase c;
    c.cutAt(0.25);
    c.cutAt(0.75);
    const auto colour = [&](const char* name) { return c.ports().find(name)->colour; };
    const auto inlet = colour("inlet"), outlet = colour("outlet"), border = colour("border_1");
    QVERIFY(inlet != outlet && outlet != border && inlet != border);
    QVERIFY(c.ports().rename("inlet", "neck").isEmpty());
    QVERIFY(colour("neck") == inlet && colour("outlet") == outlet);
    c.ports().remove("neck");
    QVERIFY(colour("outlet") == outlet && colour("border_1") == border);
    c.undo();
    QVERIFY(colour("neck") == inlet && colour("outlet") == outlet);
  }

  void aNameBeingTypedIsNotLost() {
    PortCase c;
    c.cutAt(0.5);
    c.trigger("renamePort");
    auto* editor = c.table()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText("half");
    Q_EMIT c.models().runs.statesChanged();
    Q_EMIT c.models().results.resultsChanged();
    QCOMPARE(editor->text(), QString("half"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(c.cut(0).name, std::string("half"));
  }

  void twoNamesMustDiffer() {
    PortCase c;
    c.cutAt(0.25);
    c.cutAt(0.75);
    QVERIFY(c.ports().rename("outlet", "inlet").contains("two cuts are called 'inlet'"));
    QCOMPARE(c.cut(1).name, std::string("outlet"));
    QCOMPARE(c.ports().freeName(), QString("outlet-2"));
  }

  void aCutThatCannotBeSaysWhyAndTheOthersStay() {
    PortCase c;
    c.cutAt(0.25);
    c.cutAt(0.3);
    // Nothing of the last one's vessel is between the two.
    QVERIFY(c.ports().find("outlet")->state == PortRow::State::Impossible);
    QVERIFY2(noteOf(c, "outlet").contains("outlet"), qPrintable(noteOf(c, "outlet")));
    QVERIFY(c.table()->item(1, 3)->text().contains(noteOf(c, "outlet")));
    QVERIFY(c.table()->item(1, 0)->toolTip() == noteOf(c, "outlet"));
    QVERIFY(c.ports().find("inlet")->state != PortRow::State::Impossible);
    c.click(c.find<QPushButton>("run"));
    QVERIFY2(c.models().runs.state(Step::Surface) == StepState::Failed,
             qPrintable(c.find<QPlainTextEdit>("log")->toPlainText()));
    c.ports().remove("outlet");
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFresh());
    std::vector<std::string> cuts = c.models().document.parameters().ports.cuts;
    cuts.push_back("500,500,500,0,0,1,far");
    QVERIFY(c.models().document.setCuts(cuts, "far").isEmpty());
    QVERIFY2(noteOf(c, "far").contains("no vessel"), qPrintable(noteOf(c, "far")));
    QVERIFY(!c.models().document.setCuts({"nonsense"}, "bad").isEmpty());
  }

  void theRunMakesPatchesOfTheirNames() {
    PortCase c;
    c.cutAt(0.5);
    c.ports().rename("inlet", "supra");
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFresh());
    const std::vector<Port> ports = c.models().results.ports(MeshKind::Exported);
    QVERIFY(ports.size() >= 2);
    QCOMPARE(ports[0].name, std::string("supra"));
    QVERIFY(std::abs(ports[0].areaMm2 - c.ports().find("supra")->areaMm2) < 0.1 * ports[0].areaMm2);
    QCOMPARE(noteOf(c, "supra"), QString("made"));
    c.settle();
    // The cap has the colour of its row.
    const auto colour = c.ports().find("supra")->colour;
    QVERIFY(c.ports().colours(ports)[0] == colour);
    c.ports().visit("supra");
    QVERIFY((c.window->views().crosshair() - ports[0].centreLps).norm() < 1.0);
    c.settle();
    QCOMPARE(c.table()->currentRow(), 0);
  }

  void aCutWhosePartIsLeftOutSaysSo() {
    PortCase c;
    c.cutAt(0.5);
    c.models().document.setField("segmentation.keep", std::string("all"));
    c.click(c.find<QPushButton>("run"));
    QVERIFY(!noteOf(c, "inlet").contains("left out"));
    const std::size_t openings = c.models().results.ports(MeshKind::Exported).size();
    // More than the half tube that the cut leaves, less than the other tube.
    c.models().document.setField("surface.minComponentMm3", 100.0);
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFresh());
    QVERIFY2(noteOf(c, "inlet").contains("left out"), qPrintable(noteOf(c, "inlet")));
    QVERIFY(c.ports().find("inlet")->state == PortRow::State::Advised);
    QVERIFY(c.find<QPlainTextEdit>("log")->toPlainText().contains("the cut 'inlet' with the part"));
    QVERIFY(c.models().results.ports(MeshKind::Exported).size() < openings);
  }

  void allEndsAreCutAsExplicitCuts() {
    PortCase c({}, coil());
    QCOMPARE(c.cuts(), std::size_t(0));
    c.trigger("cutEnds");
    auto* dialog = c.find<QInputDialog>("endsDialog");
    QVERIFY(dialog);
    dialog->setDoubleValue(1.0);
    dialog->accept();
    QVERIFY2(c.cuts() == 2, qPrintable(c.find<QPlainTextEdit>("log")->toPlainText()));
    QCOMPARE(c.cut(0).name.substr(0, 4), std::string("end_"));
    const std::size_t count = c.cuts();
    for (const PortRow& row : c.ports().rows())
      QVERIFY2(row.state != PortRow::State::Impossible, qPrintable(row.note));
    c.ports().cutEnds(1.0);
    QCOMPARE(c.cuts(), count);  // cut already
    c.undo();
    QCOMPARE(c.cuts(), std::size_t(0));
  }

  void workersDoTheSame() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(twoTubes());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    c.click(c.find<QPushButton>("run"));
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.meshFresh() && !c.models().busy(), kPatienceMs);
    cutAt(c, 0.5);
    QTRY_VERIFY_WITH_TIMEOUT(c.window->ports().find("inlet"), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(c.window->ports().find("inlet")->areaMm2 > 0.0, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!c.window->ports().busy(), kPatienceMs);
    QVERIFY(!c.window->ports().find("inlet")->path.empty());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestPorts>(argc, argv); }
#include "tst_ports.moc"

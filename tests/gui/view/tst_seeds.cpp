// SPDX-License-Identifier: BSD-3-Clause
#include <QMenu>

#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// A window with two tubes, run as far as the seeds, that picks seeds in the axial pane.
struct SeedCase : WindowCase {
  SeedCase() {
    models().live.setOn(false);
    models().files.take(twoTubes());
    models().runs.run(Step::Seeds);
    state().setTool(Tool::PickSeed);
    pane = window->views().slice(2);
  }
  [[nodiscard]] QPoint at(const Eigen::Vector3d& lps) const {
    return pane->positionOf(lps).toPoint();
  }
  std::vector<Eigen::Vector3d> seeds() { return models().document.seeds(); }
  int edits() { return models().document.undoStack()->count(); }
  /// Chooses a row of the menu that a right click at a place opens. @returns whether it could be
  bool choose(const Eigen::Vector3d& lps, const char* name) {
    sendMouse(*pane, QEvent::MouseButtonPress, at(lps), Qt::RightButton, Qt::RightButton);
    sendMouse(*pane, QEvent::MouseButtonRelease, at(lps), Qt::RightButton, Qt::NoButton);
    QMenu* open = nullptr;
    for (auto* menu : window->findChildren<QMenu*>("portMenu"))
      if (menu->isVisible()) open = menu;
    auto* action = open ? open->findChild<QAction*>(name) : nullptr;
    const bool possible = action && action->isEnabled();
    if (possible) action->trigger();
    if (open) open->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return possible;
  }

  SliceView* pane = nullptr;
};

/// Of the pane's pixels, those in which blue leads.
int bluePixels(SliceView& pane) {
  const QImage picture = pane.grabFramebuffer();
  int blue = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor colour = picture.pixelColor(x, y);
      if (colour.blue() > colour.red() + 40 && colour.blue() > colour.green() + 20) ++blue;
    }
  return blue;
}

}  // namespace

/// Seeds in the panes: seen, moved, taken away.
class TestSeeds : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void whoPicksSeesThoseThatWereFound() {
    SeedCase c;
    const auto found = c.models().results.seedsResult();
    QVERIFY(found && !found->pointsLps.empty());
    c.window->views().setCrosshair(found->pointsLps.front());
    QTRY_VERIFY(bluePixels(*c.pane) > 10);
    // One by hand lies above them.
    c.models().document.addSeed(found->pointsLps.front());
    const QPoint at = c.at(found->pointsLps.front());
    const auto isGreen = [&] {
      const QColor colour = c.pane->grabFramebuffer().pixelColor(at);
      return colour.green() > colour.blue() + 20;
    };
    c.pane->setCursor(found->pointsLps.front() + Eigen::Vector3d(3.0, 3.0, 0.0));
    QTRY_VERIFY(isGreen());
    c.state().setTool(Tool::Navigate);
    QTRY_COMPARE(bluePixels(*c.pane), 0);
  }

  void aSeedIsDragged() {
    SeedCase c;
    const Eigen::Vector3d middle = c.window->views().crosshair();
    c.models().document.addSeed(middle);
    c.models().document.addSeed(middle + Eigen::Vector3d(3.0, 3.0, 0.0));
    QCOMPARE(c.edits(), 2);
    const QPoint from = c.at(middle), to = from + QPoint(40, 25);
    const Eigen::Vector3d moved = c.pane->lpsAt(to) - c.pane->lpsAt(from);
    QVERIFY(moved.norm() > 1.0);
    drag(*c.pane, Qt::LeftButton, from, to);
    QCOMPARE(c.seeds().size(), std::size_t(2));
    QVERIFY((c.seeds()[0] - middle - moved).norm() < 1e-6);
    QCOMPARE(c.edits(), 3);
    c.models().document.undoStack()->undo();
    QVERIFY(c.seeds()[0] == middle);
    // With another tool the drag is of window and level.
    c.state().setTool(Tool::Navigate);
    drag(*c.pane, Qt::LeftButton, from, to);
    QVERIFY(c.seeds()[0] == middle);
  }

  void aSeedStaysInTheVolume() {
    SeedCase c;
    const Eigen::Vector3d middle = c.window->views().crosshair();
    c.models().document.addSeed(middle);
    drag(*c.pane, Qt::LeftButton, c.at(middle), QPoint(-400, 10));
    QVERIFY(c.seeds()[0] == middle);
    QCOMPARE(c.edits(), 1);
  }

  void aClickOnASeedAddsNone() {
    SeedCase c;
    const Eigen::Vector3d middle = c.window->views().crosshair();
    QTest::mouseClick(c.pane, Qt::LeftButton, {}, c.at(middle));
    QCOMPARE(c.seeds().size(), std::size_t(1));
    QTest::mouseClick(c.pane, Qt::LeftButton, {}, c.at(middle));
    QCOMPARE(c.seeds().size(), std::size_t(1));
    QTest::mouseClick(c.pane, Qt::LeftButton, {}, c.at(middle) + QPoint(60, 0));
    QCOMPARE(c.seeds().size(), std::size_t(2));
  }

  void theMenuOfAPlaceHasItsSeed() {
    SeedCase c;
    const Eigen::Vector3d here = c.window->views().crosshair();
    const Eigen::Vector3d far = here + Eigen::Vector3d(0.0, 4.0, 0.0);
    QVERIFY(!c.choose(here, "removeSeedHere"));
    QVERIFY(c.choose(here, "seedHere"));
    QVERIFY(c.choose(far, "seedHere"));
    QCOMPARE(c.seeds().size(), std::size_t(2));
    QVERIFY((c.seeds()[1] - far).norm() < 0.2);  // a pixel
    QVERIFY(c.choose(far, "removeSeedHere"));
    QCOMPARE(c.seeds().size(), std::size_t(1));
    QVERIFY((c.seeds()[0] - here).norm() < 0.2);
  }

  void thisVesselOnly() {
    SeedCase c;
    c.models().document.addSeed(c.window->views().crosshair());
    c.models().runs.run();
    const auto parts = [&] {
      int kept = 0;
      for (const ComponentRow& part : c.models().results.components())
        kept += part.ticked && !part.byRule;
      return kept;
    };
    QVERIFY(parts() > 1);
    const Eigen::Vector3d place = c.models().results.innerPoints().back();
    c.window->views().setCrosshair(place);
    const int before = c.edits();
    QVERIFY(c.choose(place, "onlyThisVessel"));
    QCOMPARE(c.edits(), before + 1);
    QCOMPARE(c.seeds().size(), std::size_t(1));
    c.models().runs.run();
    QCOMPARE(parts(), 1);
    QVERIFY(!c.models().results.components().back().byRule);
  }

 private:
  QTemporaryDir settings_;
};

QTEST_MAIN(TestSeeds)
#include "tst_seeds.moc"

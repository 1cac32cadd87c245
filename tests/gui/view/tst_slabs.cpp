// SPDX-License-Identifier: BSD-3-Clause
#include <QDoubleSpinBox>
#include <QMenu>

#include "tests/gui/window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

void rightClick(QWidget& widget, const QPoint& at) {
  sendMouse(widget, QEvent::MouseButtonPress, at, Qt::RightButton, Qt::RightButton);
  sendMouse(widget, QEvent::MouseButtonRelease, at, Qt::RightButton, Qt::NoButton);
}

/// The newest one: those that closed live on until the events of their end.
QMenu* slabMenu(WindowCase& c) {
  QMenu* found = nullptr;
  for (auto* menu : c.window->findChildren<QMenu*>("portMenu"))
    if (menu->isVisible()) found = menu->findChild<QMenu*>("slabMenu");
  return found;
}

void chooseSlab(WindowCase& c, SliceView* pane, const QString& title) {
  rightClick(*pane, pane->rect().center());
  QMenu* menu = slabMenu(c);
  QVERIFY(menu);
  for (QAction* action : menu->actions())
    if (action->text() == title) action->trigger();
  menu->parentWidget()->close();
}

}  // namespace

class TestSlabs : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void eachPaneHasItsOwn() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    chooseSlab(c, views.slice(0), "MIP");
    chooseSlab(c, views.slice(1), "Mean");
    QCOMPARE(views.slice(0)->slab().mode, SlabMode::Mip);
    QCOMPARE(views.slice(1)->slab().mode, SlabMode::Mean);
    QCOMPARE(views.slice(2)->slab().mode, SlabMode::None);
    // The tool bar says that they differ, and what it sets is of all.
    QCOMPARE(c.find<QComboBox>("slab")->currentIndex(), -1);
    wheel(*views.slice(1), {50, 50}, {120, 0}, Qt::AltModifier);
    QVERIFY(views.slice(1)->slab().thicknessMm > views.slice(0)->slab().thicknessMm);
    const Slab before = views.slice(0)->slab();
    wheel(*views.slice(0), {50, 50}, {0, 120});
    QVERIFY(views.slice(0)->slab() == before);
    c.choose(c.find<QComboBox>("slab"), 2);
    for (int plane = 0; plane < 3; ++plane)
      QCOMPARE(views.slice(plane)->slab().mode, SlabMode::MinIp);
  }

  void theMenuSetsThicknessAndSpreadsIt() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    chooseSlab(c, views.slice(2), "MIP");
    rightClick(*views.slice(2), views.slice(2)->rect().center());
    auto* thickness = slabMenu(c)->findChild<QDoubleSpinBox*>("paneThickness");
    thickness->setValue(3.5);
    QVERIFY((views.slice(2)->slab() == Slab{SlabMode::Mip, 3.5}));
    QVERIFY(views.slice(0)->slab() == Slab());
    slabMenu(c)->findChild<QAction*>("sameSlabs")->trigger();
    for (int plane = 0; plane < 3; ++plane)
      QVERIFY((views.slice(plane)->slab() == Slab{SlabMode::Mip, 3.5}));
  }

  void aKeyGoesThroughTheKinds() {
    WindowCase c;
    c.models().files.take(twoTubes());
    ViewGrid& views = c.window->views();
    for (const SlabMode mode : {SlabMode::Mip, SlabMode::MinIp, SlabMode::Mean, SlabMode::None}) {
      QTest::keyClick(views.slice(1), Qt::Key_M);
      QCOMPARE(c.state().slab(1).mode, mode);
      QCOMPARE(c.state().slab(2).mode, SlabMode::None);
    }
  }

  void theCaseKeepsThem() {
    WindowCase c;
    c.state().setSlab(0, {SlabMode::Mip, 2.5});
    c.state().setSlab(2, {SlabMode::Mean, 7.0});
    const CaseView view = c.state().caseView();
    WindowCase next;
    next.state().take(view);
    for (int plane = 0; plane < 3; ++plane)
      QVERIFY(next.state().slab(plane) == c.state().slab(plane));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestSlabs>(argc, argv); }
#include "tst_slabs.moc"

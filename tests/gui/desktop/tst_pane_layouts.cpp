// SPDX-License-Identifier: BSD-3-Clause
#include "tests/gui/window_case.h"

using namespace angiomesh;
using angiomesh::test::litShare;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

class TestPaneLayouts : public QObject {
  Q_OBJECT

 private:
  static std::vector<VtkView*> panesOf(const WindowCase& c) {
    ViewGrid& views = c.window->views();
    return {views.slice(2), views.slice(0), views.slice(1), views.surface()};
  }
  static QRect placeOf(const WindowCase& c, const QWidget* pane) {
    return {pane->mapTo(&c.window->views(), QPoint()), pane->size()};
  }
  static void press(const WindowCase& c, Qt::Key key) {
    QTest::keyClick(c.window.get(), key, Qt::ControlModifier);
  }
  static bool checked(const WindowCase& c, const char* action) {
    return c.window->findChild<QAction*>(QLatin1String(action))->isChecked();
  }
  /// Whether the pane takes most of the room, and the others lie in a column at its right.
  static bool isLarge(const WindowCase& c, VtkView* large) {
    const QRect room = c.window->views().rect();
    const QRect place = placeOf(c, large);
    if (place.width() < 0.6 * room.width() || place.height() < room.height()) return false;
    int bottom = -1;
    for (const VtkView* pane : panesOf(c)) {
      if (pane == large) continue;
      const QRect small = placeOf(c, pane);
      if (!pane->isVisible() || small.left() <= place.right() || small.top() <= bottom ||
          small.height() < 0.3 * room.height())
        return false;
      bottom = small.bottom();
    }
    return true;
  }

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void fourPanesShareTheRoomEvenly() {
    WindowCase c;
    c.models().files.take(twoTubes());
    QVERIFY(checked(c, "layoutFour"));
    const QSize half = c.window->views().size() / 2;
    for (const VtkView* pane : panesOf(c))
      QTRY_VERIFY(pane->isVisible() && std::abs(pane->width() - half.width()) <= 2 &&
                  std::abs(pane->height() - half.height()) <= 2);
  }

  void theLargePaneIsTheLastOneChosen() {
    WindowCase c;
    c.models().files.take(twoTubes());
    const auto panes = panesOf(c);
    press(c, Qt::Key_6);
    QTRY_VERIFY(isLarge(c, panes[0]));
    QVERIFY(checked(c, "layoutOneAndThree") && !checked(c, "layoutFour"));
    for (VtkView* pane : {panes[2], panes[3], panes[1]}) {
      QTest::mouseDClick(pane, Qt::LeftButton);
      QTRY_VERIFY(placeOf(c, pane) == c.window->views().rect());
      QTest::mouseDClick(pane, Qt::LeftButton);
      QTRY_VERIFY(isLarge(c, pane));
    }
    press(c, Qt::Key_5);
    QTRY_VERIFY(panes[1]->width() < 0.55 * c.window->views().width());
    press(c, Qt::Key_4);
    press(c, Qt::Key_6);
    QTRY_VERIFY(isLarge(c, panes[3]));
  }

  void aSinglePaneGivesWayToTheLayoutBefore() {
    WindowCase c;
    c.models().files.take(twoTubes());
    const auto panes = panesOf(c);
    press(c, Qt::Key_6);
    press(c, Qt::Key_7);
    QTRY_VERIFY(placeOf(c, panes[0]) == c.window->views().rect());
    QVERIFY(checked(c, "layoutSingle") && !panes[1]->isVisible() && !panes[3]->isVisible());
    press(c, Qt::Key_3);
    QTRY_VERIFY(panes[2]->isVisible() && !panes[0]->isVisible());
    QTest::mouseDClick(panes[2], Qt::LeftButton);
    QTRY_VERIFY(isLarge(c, panes[2]));
  }

  void theNextStartHasTheSameLayout() {
    {
      WindowCase c;
      press(c, Qt::Key_6);
      press(c, Qt::Key_2);
      QVERIFY(checked(c, "layoutSingle"));
    }
    WindowCase c;
    c.models().files.take(twoTubes());
    const auto panes = panesOf(c);
    QTRY_VERIFY(placeOf(c, panes[1]) == c.window->views().rect());
    QVERIFY(checked(c, "layoutSingle"));
    QTest::mouseDClick(panes[1], Qt::LeftButton);
    QTRY_VERIFY(isLarge(c, panes[1]));
  }

  void slicesFillAPaneThatGrows() {
    WindowCase c;
    c.models().files.take(twoTubes());
    SliceView* axial = c.window->views().slice(2);
    const double before = litShare(axial->grabFramebuffer());
    press(c, Qt::Key_7);
    QTRY_VERIFY(placeOf(c, axial) == c.window->views().rect());
    QVERIFY(std::abs(litShare(axial->grabFramebuffer()) - before) < 0.5 * before);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestPaneLayouts>(argc, argv); }
#include "tst_pane_layouts.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <malloc.h>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>

#include "core/base/random.h"
#include "tests/gui/window_case.h"

using namespace angiomesh;
using angiomesh::test::WindowCase;

namespace {

/// What ends the session, or opens what the system draws.
const QSet<QString> kNever{"quit"};

/// Resident memory, MB.
double memoryMb() {
  QFile status("/proc/self/status");
  if (!status.open(QIODevice::ReadOnly)) return 0.0;
  const QRegularExpression rss("VmRSS:\\s+(\\d+) kB");
  const auto match = rss.match(QString::fromLatin1(status.readAll()));
  return match.captured(1).toDouble() / 1024.0;
}

/// The same with a fresh volume, no run on, and what the heap can give back given back: what the
/// pipeline remembers comes and goes with the actions.
double memoryAtRestMb(WindowCase& c) {
  c.models().cancel();
  for (int patience = 0; c.models().busy() && patience < test::kPatienceMs; patience += 20)
    QTest::qWait(20);
  c.models().files.take(test::twoTubes());
  QTest::qWait(300);
  malloc_trim(0);
  return memoryMb();
}

/// Somebody who does anything anywhere.
class Anybody {
 public:
  Anybody(WindowCase& window, std::uint64_t seed) : case_(window), seed_(seed) {}

  /// @returns what was done
  QString act() {
    closeDialogs();
    const int kind = upTo(10);
    if (kind < 3) return trigger();
    if (kind < 7) return useMouse();
    if (kind < 9) return useWidget();
    return pressKey();
  }

 private:
  int upTo(int count) {
    return std::min(static_cast<int>(randomUniform(seed_, counter_++) * count), count - 1);
  }
  template <class List>
  auto oneOf(const List& list) {
    return list[upTo(static_cast<int>(list.size()))];
  }

  void closeDialogs() {
    for (int n = 0; n < 20; ++n) {
      QWidget* open = QApplication::activePopupWidget();
      if (open == nullptr)
        for (QWidget* top : QApplication::topLevelWidgets())
          if (top->isVisible() && qobject_cast<QDialog*>(top) != nullptr) open = top;
      if (open == nullptr) return;
      // Now and then a dialog is answered first.
      auto* dialog = qobject_cast<QDialog*>(open);
      if (dialog == nullptr)
        open->close();
      else if (upTo(3) == 0)
        dialog->accept();
      else
        dialog->reject();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
  }

  QString trigger() {
    QList<QAction*> actions;
    for (QAction* action : case_.window->findChildren<QAction*>())
      if (action->isEnabled() && !action->text().isEmpty() && action->menu() == nullptr &&
          !kNever.contains(action->objectName()))
        actions << action;
    QAction* action = oneOf(actions);
    const QString name = action->objectName() + ' ' + action->text();
    action->trigger();
    return "action " + name;
  }

  QString useMouse() {
    ViewGrid& views = case_.window->views();
    const QList<QWidget*> panes{views.slice(0), views.slice(1), views.slice(2), views.surface()};
    QWidget* pane = oneOf(panes);
    if (!pane->isVisible()) return "a hidden pane";
    const auto place = [&] { return QPoint(upTo(pane->width()), upTo(pane->height())); };
    const QList<Qt::KeyboardModifiers> modifiers{Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
                                                 Qt::ControlModifier, Qt::AltModifier};
    const QList<Qt::MouseButton> buttons{Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    const Qt::KeyboardModifiers held = oneOf(modifiers);
    switch (upTo(4)) {
      case 0:
        test::wheel(*pane, place(), {0, upTo(2) == 0 ? 120 : -120}, held);
        return "wheel";
      case 1:
        test::drag(*pane, oneOf(buttons), place(), place(), held);
        return "drag";
      case 2:
        QTest::mouseClick(pane, oneOf(buttons), held, place());
        return "click";
      default:
        QTest::mouseDClick(pane, Qt::LeftButton, held, place());
        return "double click";
    }
  }

  QString useWidget() {
    QList<QWidget*> widgets;
    for (QWidget* widget : case_.window->findChildren<QWidget*>())
      if (widget->isVisible() && widget->isEnabled() &&
          (qobject_cast<QAbstractSlider*>(widget) || qobject_cast<QAbstractButton*>(widget) ||
           qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
           qobject_cast<QTableWidget*>(widget)))
        widgets << widget;
    if (widgets.isEmpty()) return "no panel and no tool bar is left";
    QWidget* widget = oneOf(widgets);
    const QString what =
        QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
    if (auto* combo = qobject_cast<QComboBox*>(widget)) {
      case_.choose(combo, combo->count() > 0 ? upTo(combo->count()) : 0);
    } else if (auto* slider = qobject_cast<QAbstractSlider*>(widget)) {
      slider->setValue(slider->minimum() + upTo(slider->maximum() - slider->minimum() + 1));
    } else if (qobject_cast<QAbstractSpinBox*>(widget)) {
      QTest::keyClick(widget, upTo(2) == 0 ? Qt::Key_Up : Qt::Key_Down);
    } else if (auto* table = qobject_cast<QTableWidget*>(widget)) {
      QTest::mouseClick(
          table->viewport(), Qt::LeftButton, Qt::NoModifier,
          QPoint(upTo(table->viewport()->width()), upTo(table->viewport()->height())));
    } else if (widget->objectName() != QLatin1String("quit")) {
      case_.click(widget);
    }
    return what;
  }

  QString pressKey() {
    const QList<Qt::Key> keys{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,
                              Qt::Key_R,    Qt::Key_N,     Qt::Key_M,      Qt::Key_T,
                              Qt::Key_A,    Qt::Key_1,     Qt::Key_2,      Qt::Key_Escape,
                              Qt::Key_F5,   Qt::Key_Space, Qt::Key_Delete, Qt::Key_Tab};
    ViewGrid& views = case_.window->views();
    const QList<QWidget*> panes{views.slice(0), views.slice(2), views.surface()};
    const Qt::Key key = oneOf(keys);
    QTest::keyClick(oneOf(panes), key);
    return QString("key %1").arg(key);
  }

  WindowCase& case_;
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

}  // namespace

/// Whatever one does while runs go on, the window stays, answers, and does not grow. The variables
/// ANGIOMESH_ACTIONS and ANGIOMESH_SEED ask for more actions, and others.
class TestRandomActions : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anythingGoes() {
    const int count = qEnvironmentVariableIntValue("ANGIOMESH_ACTIONS");
    const int actions = count > 0 ? count : 150;
    const auto seed = static_cast<std::uint64_t>(qEnvironmentVariableIntValue("ANGIOMESH_SEED"));
    WindowCase c(makeThreadedJobRunner);
    c.openPath = c.folder.filePath("none.mha");
    c.savePath = c.folder.filePath("out.ply");
    c.answers.savePath = c.folder.filePath("a.angiomesh");
    c.models().files.take(test::twoTubes());
    QTRY_VERIFY(c.models().document.hasCase());
    Anybody anybody(c, seed);
    // A button's menu waits for an answer in a loop of its own.
    QTimer impatient;
    connect(&impatient, &QTimer::timeout, this, [] {
      if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    });
    impatient.start(50);
    double before = 0.0;
    for (int n = 0; n < actions; ++n) {
      if (n % 20 == 0) {
        // A volume to work on, and a run that is on.
        if (!c.models().document.hasCase() || n % 500 == 0) c.models().files.take(test::twoTubes());
        c.models().runs.run();
      }
      const QString what = anybody.act();
      if (qEnvironmentVariableIsSet("ANGIOMESH_TELL")) qInfo("%d: %s", n, qPrintable(what));
      QCoreApplication::processEvents();
      c.models().timer.poll();
      QVERIFY2(c.window->isVisible(), qPrintable(what));
      if (n == actions / 2) before = memoryAtRestMb(c);
    }
    const double after = memoryAtRestMb(c);
    QVERIFY(!c.models().busy());
    qInfo("%d actions, %.0f MB at half of them, %.0f MB at the end", actions, before, after);
    QVERIFY2(after < 1.2 * before + 80.0,
             qPrintable(QString("%1 MB, then %2 MB").arg(before).arg(after)));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestRandomActions>(argc, argv); }
#include "tst_random_actions.moc"

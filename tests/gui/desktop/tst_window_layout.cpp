// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>

#include "fresh_window.h"

using namespace angiomesh;
using angiomesh::test::FreshWindow;
using angiomesh::test::kPatienceMs;
using angiomesh::test::slowTree;
using angiomesh::test::twoTubes;

namespace {

constexpr std::array<const char*, 3> kWorkspaces{"workspaceReview", "workspaceTune",
                                                 "workspaceMesh"};

QString nameOf(const QWidget& widget, const QString& text) {
  return QStringLiteral("%1 \"%2\" in %3, %4 wide, wants %5")
      .arg(widget.metaObject()->className(), text, widget.parentWidget()->objectName())
      .arg(widget.width())
      .arg(widget.sizeHint().width());
}

/// Whether no ancestor cuts the widget off at its left or right.
bool isWhole(const QWidget& widget) {
  for (const QWidget* above = widget.parentWidget(); above; above = above->parentWidget()) {
    const int left = widget.mapTo(above, QPoint()).x();
    if (left < 0 || left + widget.width() > above->width()) return false;
    if (above->isWindow()) break;
  }
  return true;
}

/// What of the window's text is cut off.
QStringList clipped(const QWidget& window) {
  QStringList list;
  const auto check = [&](const QWidget& widget, const QString& text, bool fits) {
    if (widget.isVisible() && !text.isEmpty() && !(fits && isWhole(widget)))
      list << nameOf(widget, text);
  };
  for (const auto* label : window.findChildren<QLabel*>()) {
    const bool fits = label->wordWrap()
                          ? label->heightForWidth(label->width()) <= label->height() &&
                                label->minimumSizeHint().width() <= label->width()
                          : label->sizeHint().width() <= label->width();
    check(*label, label->text(), fits);
  }
  for (const auto* button : window.findChildren<QAbstractButton*>())
    check(*button, button->text(), button->sizeHint().width() <= button->width());
  return list;
}

/// Where the sliders and the panes are painted next.
std::vector<QRect> placesOf(MainWindow& window) {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  std::vector<QRect> places;
  for (const auto* slider : window.findChildren<QSlider*>())
    if (slider->isVisible()) places.emplace_back(slider->mapTo(&window, QPoint()), slider->size());
  places.emplace_back(window.views().mapTo(&window, QPoint()), window.views().size());
  return places;
}

/// What of them lies elsewhere than before.
QString moved(const std::vector<QRect>& before, const std::vector<QRect>& now) {
  QString text;
  QDebug(&text) << "were" << before.size() << "are" << now.size();
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i)
    if (before[i] != now[i]) QDebug(&text) << i << before[i] << now[i];
  return text;
}

}  // namespace

class TestWindowLayout : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void allTextFits_data() {
    QTest::addColumn<int>("points");
    QTest::newRow("usual font") << 0;
    QTest::newRow("large font") << 14;
  }
  void allTextFits() {
    QFETCH(int, points);
    const QFont usual = QApplication::font();
    if (points > 0) {
      QFont large = usual;
      large.setPointSize(points);
      QApplication::setFont(large);
    }
    {
      FreshWindow w({1280, 800});
      for (const bool run : {false, true}) {
        if (run) {
          w.window->models().files.take(twoTubes());
          w.window->models().runs.run();
          QVERIFY(w.window->models().runs.state(Step::Quality) == StepState::Fresh);
        }
        for (const char* workspace : kWorkspaces) {
          w.clickTool(workspace);
          for (auto* more : w.window->findChildren<QToolButton*>("more")) more->setChecked(run);
          QTRY_VERIFY2(clipped(*w.window).isEmpty(),
                       qPrintable(clipped(*w.window).join('\n') + '\n' + workspace));
          QVERIFY2(w.window->size() == QSize(1280, 800),
                   qPrintable(QString("%1: %2 wide").arg(workspace).arg(w.window->width())));
        }
      }
    }
    QApplication::setFont(usual);
  }

  void nothingMovesDuringARun_data() {
    QTest::addColumn<QString>("workspace");
    QTest::addColumn<QString>("dock");
    QTest::addColumn<int>("things");
    QTest::newRow("review") << "workspaceReview"
                            << "" << 1;
    QTest::newRow("tune") << "workspaceTune"
                          << "" << 10;
    for (const char* dock : {"portsDock", "measureDock", "whyDock", "reviewDock"})
      QTest::newRow(dock) << "workspaceMesh" << dock << 1;
  }
  void nothingMovesDuringARun() {
    QFETCH(QString, workspace);
    QFETCH(QString, dock);
    QFETCH(int, things);
    FreshWindow w({1280, 800}, makeThreadedJobRunner);
    w.clickTool(workspace.toLatin1());
    if (!dock.isEmpty()) {
      auto* widget = w.window->findChild<QDockWidget*>(dock);
      widget->show();
      widget->raise();
    }
    w.window->models().files.take(slowTree());
    QTRY_VERIFY_WITH_TIMEOUT(w.window->models().document.hasCase(), kPatienceMs);
    QTest::qWait(100);
    const std::vector<QRect> before = placesOf(*w.window);
    QVERIFY(static_cast<int>(before.size()) >= things);
    RunModel& runs = w.window->models().runs;
    w.clickTool("runAll");
    QVERIFY(runs.running());
    int looks = 0;
    while (runs.running()) {
      QTest::qWait(20);
      const std::vector<QRect> now = placesOf(*w.window);
      QVERIFY2(now == before, qPrintable(w.work()->text() + moved(before, now)));
      ++looks;
    }
    QVERIFY(looks > 10 && runs.state(Step::Quality) == StepState::Fresh);
    QTest::qWait(100);
    QVERIFY(placesOf(*w.window) == before);
  }

  void nothingMovesWhenAStepFails() {
    FreshWindow w({1280, 800});
    w.clickTool("workspaceTune");
    w.window->models().files.take(twoTubes());
    QTest::qWait(100);
    const std::vector<QRect> before = placesOf(*w.window);
    w.window->models().document.setField("seeds.automatic", false);
    w.window->models().runs.run();
    QVERIFY(w.window->models().runs.state(Step::Seeds) == StepState::Failed);
    QTest::qWait(100);
    QVERIFY(placesOf(*w.window) == before);
    const auto* reason = w.window->findChild<QLabel*>("failure");
    QVERIFY2(reason->isVisible() && reason->text().contains("seed"), qPrintable(reason->text()));
    w.window->models().document.undoStack()->undo();
    QTest::qWait(100);
    QVERIFY(placesOf(*w.window) == before);
    QVERIFY(reason->text().isEmpty());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestWindowLayout>(argc, argv); }
#include "tst_window_layout.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include <QToolButton>
#include <cmath>

#include "fresh_window.h"
#include "gui/action_icon.h"
#include "gui/panel/evolution_panel.h"
#include "gui/theme.h"

using namespace angiomesh;
using angiomesh::test::FreshWindow;
using angiomesh::test::twoTubes;

namespace {

double luminance(const QColor& colour) {
  const auto linear = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

/// As WCAG 2.1 defines it: 1 to 21; text is readable from 4.5.
double contrast(const QColor& a, const QColor& b) {
  const double low = std::min(luminance(a), luminance(b));
  const double high = std::max(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

/// The largest contrast of a pixel with the picture's corner.
double contrastIn(const QImage& picture) {
  const QColor ground = picture.pixelColor(1, 1);
  double best = 1.0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      best = std::max(best, contrast(ground, picture.pixelColor(x, y)));
  return best;
}

QColor colourOfIcon(QIcon::Mode mode) {
  return actionIcon("runAll").pixmap(QSize(24, 24), mode).toImage().pixelColor(11, 12);
}

}  // namespace

class TestTheme : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }
  void cleanup() { applyTheme(Theme::System); }

  void themesAreChosenAndRemembered() {
    const int system = QApplication::palette().color(QPalette::Window).lightness();
    {
      FreshWindow w;
      QVERIFY(w.window->findChild<QAction*>("themeSystem")->isChecked());
      w.window->findChild<QAction*>("themeDark")->trigger();
      QTRY_VERIFY(w.window->palette().color(QPalette::Window).lightness() < 80);
    }
    QVERIFY(rememberedTheme() == Theme::Dark);
    FreshWindow w;
    QVERIFY(w.window->findChild<QAction*>("themeDark")->isChecked());
    w.window->findChild<QAction*>("themeLight")->trigger();
    QTRY_VERIFY(w.window->palette().color(QPalette::Window).lightness() > 200);
    w.window->findChild<QAction*>("themeSystem")->trigger();
    QTRY_COMPARE(w.window->palette().color(QPalette::Window).lightness(), system);
    QVERIFY(rememberedTheme() == Theme::System);
  }

  void everythingIsReadable_data() {
    QTest::addColumn<int>("theme");
    QTest::newRow("light") << static_cast<int>(Theme::Light);
    QTest::newRow("dark") << static_cast<int>(Theme::Dark);
  }
  void everythingIsReadable() {
    QFETCH(int, theme);
    applyTheme(static_cast<Theme>(theme));
    FreshWindow w;
    w.clickTool("workspaceMesh");
    w.window->models().files.take(twoTubes());
    w.window->models().runs.run();
    const QPalette palette = w.window->palette();
    const auto readable = [&](QPalette::ColorRole text, QPalette::ColorRole ground) {
      return contrast(palette.color(text), palette.color(ground)) >= 4.5;
    };
    QVERIFY(readable(QPalette::WindowText, QPalette::Window));
    QVERIFY(readable(QPalette::Text, QPalette::Base));
    QVERIFY(readable(QPalette::Text, QPalette::AlternateBase));
    QVERIFY(readable(QPalette::ButtonText, QPalette::Button));
    QVERIFY(readable(QPalette::ToolTipText, QPalette::ToolTipBase));
    auto* plot = w.window->findChild<QWidget*>("histogram");
    QCOMPARE(plot->grab().toImage().pixelColor(1, 1), palette.color(QPalette::Base));
    QVERIFY(contrastIn(plot->grab().toImage()) >= 4.5);
    auto* convergence = w.window->findChild<ConvergencePlot*>();
    QVERIFY(contrastIn(convergence->grab().toImage()) >= 4.5);
    QVERIFY(contrastIn(w.window->findChild<QWidget*>("quality")->grab().toImage()) >= 4.5);
  }

  void whatIsDimmedFollowsTheTheme() {
    applyTheme(Theme::Light);
    FreshWindow w;
    w.clickTool("workspaceMesh");
    w.window->models().files.take(twoTubes());
    w.window->models().runs.run();
    w.window->models().document.setField("levelset.xi", 35.0);
    const auto* table = w.window->findChild<QWidget*>("quality");
    const auto faint = [] {
      return QApplication::palette().color(QPalette::Disabled, QPalette::Text);
    };
    QCOMPARE(table->palette().color(QPalette::Text), faint());
    w.window->findChild<QAction*>("themeDark")->trigger();
    QTRY_COMPARE(table->palette().color(QPalette::Text), faint());
    w.window->models().document.undoStack()->undo();
    QCOMPARE(table->palette().color(QPalette::Text),
             QApplication::palette().color(QPalette::Active, QPalette::Text));
  }

  void iconsTakeTheColourOfText() {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
      applyTheme(theme);
      const QPalette palette = QApplication::palette();
      QCOMPARE(colourOfIcon(QIcon::Normal), palette.color(QPalette::Active, QPalette::ButtonText));
      QCOMPARE(colourOfIcon(QIcon::Disabled),
               palette.color(QPalette::Disabled, QPalette::ButtonText));
    }
    QVERIFY(actionIcon("noSuchAction").isNull());
  }

  void theToolBarsShowAllTools_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<QSize>("size");
    QTest::newRow("usual") << 0 << QSize(1560, 960);
    QTest::newRow("small") << 0 << QSize(1280, 800);
    QTest::newRow("large font") << 14 << QSize(1280, 800);
  }
  void theToolBarsShowAllTools() {
    QFETCH(int, points);
    QFETCH(QSize, size);
    const QFont usual = QApplication::font();
    if (points > 0) QApplication::setFont(QFont(usual.family(), points));
    {
      FreshWindow w(size);
      int tools = 0;
      for (const auto* bar : w.window->findChildren<QToolBar*>()) {
        QTRY_VERIFY(bar->sizeHint().width() <= bar->width());
        for (QAction* action : bar->actions()) {
          const QWidget* widget = bar->widgetForAction(action);
          QTRY_VERIFY2(widget->isVisible(), qPrintable(action->text()));
          if (action->objectName().isEmpty() || action->isSeparator()) continue;
          QVERIFY2(!action->icon().isNull(), qPrintable(action->text()));
          QVERIFY(!action->toolTip().isEmpty());
          ++tools;
        }
        const bool text = bar->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
        QVERIFY(text || points > 0);
        if (points == 0) continue;
        // With room, the text is there again.
        w.window->resize(2200, 900);
        QTRY_VERIFY(bar->toolButtonStyle() == Qt::ToolButtonTextBesideIcon);
        w.window->resize(size);
        QTRY_VERIFY((bar->toolButtonStyle() == Qt::ToolButtonTextBesideIcon) == text);
      }
      QCOMPARE(tools, 20);
    }
    QApplication::setFont(usual);
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestTheme>(argc, argv); }
#include "tst_theme.moc"

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

#include "tests/gui/window_case.h"

namespace angiomesh::test {

/// A window as a user has it who starts the program.
struct FreshWindow {
  explicit FreshWindow(const QSize& size = {1560, 960},
                       const JobRunnerFactory& makeRunner = makeInlineJobRunner) {
    MainWindowOptions options;
    options.makeRunner = makeRunner;
    options.questions.saveChanges = [](QWidget*, const QString&) { return SaveAnswer::Discard; };
    window = std::make_unique<MainWindow>(std::move(options));
    window->resize(size);
    window->show();
    QApplication::setActiveWindow(window.get());
    [[maybe_unused]] const bool shown = QTest::qWaitForWindowExposed(window.get());
  }

  [[nodiscard]] QStringList docks() const {
    QStringList open;
    for (const auto* dock : window->findChildren<QDockWidget*>())
      if (dock->isVisible()) open << dock->objectName();
    open.sort();
    return open;
  }
  [[nodiscard]] QWidget* buttonOf(const char* action) const {
    for (const auto* bar : window->findChildren<QToolBar*>())
      if (QWidget* button =
              bar->widgetForAction(window->findChild<QAction*>(QLatin1String(action))))
        return button;
    return nullptr;
  }
  void clickTool(const char* action) const { QTest::mouseClick(buttonOf(action), Qt::LeftButton); }
  /// The status bar's line on what is being computed.
  [[nodiscard]] QLabel* work() const { return window->findChild<QLabel*>("work"); }
  void press(Qt::Key key) const { QTest::keyClick(window.get(), key, Qt::ControlModifier); }

  std::unique_ptr<MainWindow> window;
};

}  // namespace angiomesh::test

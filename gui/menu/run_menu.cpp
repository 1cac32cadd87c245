// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/run_menu.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "gui/menu/window_actions.h"

namespace angiomesh {

namespace {

constexpr int kStepIterations = 10;

}  // namespace

void addRunMenu(QMainWindow* window, CaseModels& models, CaseSensitivity& sensitivity,
                const std::function<void()>& cancel) {
  QMenu* run = window->menuBar()->addMenu(QObject::tr("&Run"));
  addMenuAction(window, run, "runAll", QObject::tr("Run"), QKeySequence(Qt::Key_F5),
                [&models] { models.runs.run(); });
  addMenuAction(window, run, "cancelRun", QObject::tr("Cancel"), QKeySequence(Qt::Key_Escape),
                cancel);
  run->addSeparator();
  addMenuAction(window, run, "pauseRun", QObject::tr("Pause"), QKeySequence(Qt::Key_F6),
                [&models] { models.runs.setPaused(!models.runs.paused()); });
  addMenuAction(window, run, "stepRun", QObject::tr("Step"), QKeySequence(Qt::Key_F7),
                [&models] { models.runs.stepEvolution(kStepIterations); });
  addMenuAction(window, run, "finishRun", QObject::tr("Finish"), QKeySequence(Qt::Key_F8),
                [&models] { models.runs.finishEvolution(); });
  run->addSeparator();
  auto* dock = window->findChild<QDockWidget*>("sensitivityDock");
  QAction* tried =
      addMenuAction(window, run, "trySensitivity", QObject::tr("Sensitivity to the parameters"),
                    QKeySequence(Qt::CTRL | Qt::Key_F5), [dock, &sensitivity] {
                      dock->show();
                      dock->raise();
                      sensitivity.start();
                    });
  const auto refresh = [tried, &sensitivity] {
    tried->setEnabled(!sensitivity.busy() && sensitivity.whyNot().isEmpty());
  };
  QObject::connect(&sensitivity, &CaseSensitivity::changed, tried, refresh);
  refresh();
}

}  // namespace angiomesh

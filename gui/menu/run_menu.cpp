// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/run_menu.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "gui/menu/window_actions.h"

namespace angiomesh {

namespace {

constexpr int kStepIterations = 10;

QString tr(const char* text) { return QCoreApplication::translate("RunMenu", text); }

}  // namespace

void addRunMenu(QMainWindow* window, CaseModels& models, const std::function<void()>& cancel) {
  QMenu* run = window->menuBar()->addMenu(tr("&Run"));
  addMenuAction(window, run, "runAll", tr("Run"), QKeySequence(Qt::Key_F5),
                [&models] { models.runs.run(); });
  addMenuAction(window, run, "cancelRun", tr("Cancel"), QKeySequence(Qt::Key_Escape), cancel);
  run->addSeparator();
  addMenuAction(window, run, "pauseRun", tr("Pause"), QKeySequence(Qt::Key_F6),
                [&models] { models.runs.setPaused(!models.runs.paused()); });
  addMenuAction(window, run, "stepRun", tr("Step"), QKeySequence(Qt::Key_F7),
                [&models] { models.runs.stepEvolution(kStepIterations); });
  addMenuAction(window, run, "finishRun", tr("Finish"), QKeySequence(Qt::Key_F8),
                [&models] { models.runs.finishEvolution(); });
}

}  // namespace angiomesh

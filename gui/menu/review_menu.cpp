// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/review_menu.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>

#include "gui/menu/window_actions.h"

namespace angiomesh {

void addReviewMenu(QMainWindow* window, CaseReviewModel& review) {
  QMenu* menu = window->menuBar()->addMenu(QObject::tr("Revie&w"));
  auto* panel = window->findChild<QDockWidget*>("reviewDock");
  addMenuAction(window, menu, "openReview", QObject::tr("Open the review"),
                QKeySequence(QObject::tr("Ctrl+Alt+R")), [panel] {
                  panel->show();
                  panel->raise();
                });
  addMenuAction(window, menu, "nextDoubt", QObject::tr("Next doubtful place"),
                QKeySequence(Qt::Key_N), [&review] { review.step(1); });
  addMenuAction(window, menu, "previousDoubt", QObject::tr("Previous doubtful place"),
                QKeySequence(Qt::SHIFT | Qt::Key_N), [&review] { review.step(-1); });
  addMenuAction(window, menu, "addRemark", QObject::tr("Add a remark at the crosshair"),
                QKeySequence(QObject::tr("Ctrl+Alt+M")), [window, panel] {
                  panel->show();
                  panel->raise();
                  window->findChild<QPushButton*>("remarkAdd")->click();
                });
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/window_actions.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

namespace angiomesh {

QAction* addMenuAction(QMainWindow* window, QMenu* menu, const char* name, const QString& text,
                       const QKeySequence& shortcut, const std::function<void()>& slot) {
  QAction* action = menu->addAction(text, window, slot);
  action->setObjectName(QLatin1String(name));
  action->setParent(window);
  if (!shortcut.isEmpty()) {
    action->setShortcut(shortcut);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(text, shortcut.toString(QKeySequence::NativeText)));
  }
  return action;
}

QAction* addMenuToggle(QMainWindow* window, QMenu* menu, const char* name, const QString& text,
                       const QKeySequence& shortcut, const std::function<void(bool)>& slot) {
  QAction* action = addMenuAction(window, menu, name, text, shortcut, [] {});
  action->setCheckable(true);
  QObject::connect(action, &QAction::triggered, window, slot);
  return action;
}

void addMenuButton(QMainWindow* window, QToolBar* bar, const char* name, const QString& text,
                   QMenu* menu) {
  // Not the menu's own action: its icon would stand in the menu bar.
  auto* entry = new QAction(text, window);
  entry->setObjectName(QLatin1String(name));
  entry->setMenu(menu);
  const QList<QAction*> all = bar->actions();
  const qsizetype after = all.indexOf(actionOf(window, "toolCut")) + 1;
  bar->insertAction(after < all.size() ? all[after] : nullptr, entry);
  if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(entry)))
    button->setPopupMode(QToolButton::InstantPopup);
}

QAction* actionOf(const QMainWindow* window, const char* name) {
  return window->findChild<QAction*>(QLatin1String(name));
}

void enableActions(const QMainWindow* window, std::initializer_list<const char*> names, bool on) {
  for (const char* name : names) actionOf(window, name)->setEnabled(on);
}

}  // namespace angiomesh

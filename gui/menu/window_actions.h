// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>
#include <initializer_list>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace angiomesh {

/// An action of the window's, found again by its name; its tooltip says its shortcut.
QAction* addMenuAction(QMainWindow* window, QMenu* menu, const char* name, const QString& text,
                       const QKeySequence& shortcut, const std::function<void()>& slot);
/// The same, to be switched on and off.
QAction* addMenuToggle(QMainWindow* window, QMenu* menu, const char* name, const QString& text,
                       const QKeySequence& shortcut, const std::function<void(bool)>& slot);

/// A button of a bar that opens a menu, behind the tools that act with the mouse.
void addMenuButton(QMainWindow* window, QToolBar* bar, const char* name, const QString& text,
                   QMenu* menu);

QAction* actionOf(const QMainWindow* window, const char* name);
void enableActions(const QMainWindow* window, std::initializer_list<const char*> names, bool on);

}  // namespace angiomesh

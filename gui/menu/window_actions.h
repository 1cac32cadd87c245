// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>
#include <initializer_list>

class QAction;
class QMainWindow;
class QMenu;

namespace angiomesh {

/// An action of the window's, found again by its name; its tooltip says its shortcut.
QAction* addMenuAction(QMainWindow* window, QMenu* menu, const char* name, const QString& text,
                       const QKeySequence& shortcut, const std::function<void()>& slot);
/// The same, to be switched on and off.
QAction* addMenuToggle(QMainWindow* window, QMenu* menu, const char* name, const QString& text,
                       const QKeySequence& shortcut, const std::function<void(bool)>& slot);

QAction* actionOf(const QMainWindow* window, const char* name);
void enableActions(const QMainWindow* window, std::initializer_list<const char*> names, bool on);

}  // namespace angiomesh

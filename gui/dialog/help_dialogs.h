// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QWidget;

namespace angiomesh {

/// Lists the shortcuts of the window's actions, and the keys and mouse buttons of the panes.
void showShortcuts(QWidget* window);
void showAbout(QWidget* window);

}  // namespace angiomesh

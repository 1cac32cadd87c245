// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>

class QAction;
class QVBoxLayout;
class QWidget;

namespace angiomesh {

/// Adds buttons for the window's actions to the end of a column, in rows of `perRow`.
void addActionButtons(QWidget* panel, QVBoxLayout* column, const QList<QAction*>& actions,
                      int perRow);

}  // namespace angiomesh

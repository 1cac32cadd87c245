// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/action_buttons.h"

#include <QAction>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace angiomesh {

void addActionButtons(QWidget* panel, QVBoxLayout* column, const QList<QAction*>& actions,
                      int perRow) {
  auto* grid = new QGridLayout;
  grid->setSpacing(3);
  for (int i = 0; i < actions.size(); ++i) {
    auto* button = new QToolButton(panel);
    button->setDefaultAction(actions[i]);
    button->setObjectName(actions[i]->objectName() + "Button");
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(button, i / perRow, i % perRow);
  }
  column->addLayout(grid);
}

}  // namespace angiomesh

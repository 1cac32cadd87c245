// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/help_dialogs.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QMessageBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>
#include <vector>

#include "core/pipeline/report.h"
#include "gui/panel/named.h"

namespace angiomesh {

namespace {

/// Keys and mouse buttons that are not actions of the window.
const std::vector<std::pair<const char*, const char*>>& paneShortcuts() {
  static const std::vector<std::pair<const char*, const char*>> table{
      {"Left drag on a slice", "Window and level (Engineering: crosshair; Ctrl: fine)"},
      {"Left click", "Crosshair in all panes; in 3D on the surface"},
      {"Middle drag", "Pan"},
      {"Right drag", "Zoom"},
      {"Wheel on a slice", "Next or previous slice"},
      {"Ctrl+wheel", "Zoom"},
      {"Alt+wheel", "Slab thickness"},
      {"Shift+move", "Crosshair in all panes"},
      {"Right click", "Menu: windows; cut the vessel there; on a port: flip, rename, delete"},
      {"Left drag on a port", "Along the vessel (Shift: anywhere); by the arrow: tilt"},
      {"Double click", "One pane at full size, and back"},
      {"Arrow keys over a slice", "Next or previous slice (Shift: by 10)"},
      {"R", "Reset the pane under the mouse"},
      {"A, P, L, Shift+R, S, I over 3D", "Look from anterior, posterior, left, right, ..."}};
  return table;
}

}  // namespace

void showShortcuts(QWidget* window) {
  auto* dialog = named(new QDialog(window), "shortcutsDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Shortcuts"));
  dialog->resize(560, 640);
  auto* table = named(new QTableWidget(0, 2, dialog), "shortcutsTable");
  table->setHorizontalHeaderLabels({QObject::tr("Key or mouse"), QObject::tr("What it does")});
  table->verticalHeader()->hide();
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  const auto add = [table](const QString& keys, const QString& what) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setItem(row, 0, new QTableWidgetItem(keys));
    table->setItem(row, 1, new QTableWidgetItem(what));
  };
  for (const QAction* action : window->findChildren<QAction*>())
    if (!action->shortcut().isEmpty())
      add(action->shortcut().toString(QKeySequence::NativeText), action->iconText());
  for (const auto& [keys, what] : paneShortcuts())
    add(QString::fromUtf8(keys), QString::fromUtf8(what));
  table->resizeColumnsToContents();
  table->horizontalHeader()->setStretchLastSection(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(table);
  column->addWidget(buttons);
  dialog->open();
}

void showAbout(QWidget* window) {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, QObject::tr("About Angiomesh"),
      QObject::tr(
          "Angiomesh %1\n\nFrom an angiogram to a vessel surface that a flow solver accepts.\n"
          "Not a medical device: research use only.\n\nBSD-3-Clause.")
          .arg(QString::fromLatin1(versionText())),
      QMessageBox::Close, window);
  box->setObjectName("aboutBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace angiomesh

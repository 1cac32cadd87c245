// SPDX-License-Identifier: BSD-3-Clause
#include <QActionGroup>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QMenuBar>
#include <QMessageBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>

#include "core/pipeline/report.h"
#include "gui/main_window.h"
#include "gui/model/view_state.h"
#include "gui/panel/view_grid.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

constexpr int kStepIterations = 10;

/// Keys and mouse buttons that are not actions of the window.
const std::vector<std::pair<const char*, const char*>>& paneShortcuts() {
  static const std::vector<std::pair<const char*, const char*>> table{
      {"Left drag on a slice", "Window and level (Engineering: crosshair; Ctrl: fine)"},
      {"Middle drag", "Pan"},
      {"Right drag", "Zoom"},
      {"Wheel on a slice", "Next or previous slice"},
      {"Ctrl+wheel", "Zoom"},
      {"Alt+wheel", "Slab thickness"},
      {"Shift+move", "Crosshair in all panes"},
      {"Right click", "Menu: cut the vessel there; on a port: flip, rename, delete"},
      {"Left drag on a port", "Along the vessel (Shift: anywhere); by the arrow: tilt"},
      {"Double click", "One pane at full size, and back"},
      {"Arrow keys on a slice", "Next or previous slice (Shift: by 10)"},
      {"R", "Reset this pane"},
      {"A, P, L, Shift+R, S, I in 3D", "Look from anterior, posterior, left, right, ..."}};
  return table;
}

}  // namespace

QAction* MainWindow::addAction(QMenu* menu, const char* name, const QString& text,
                               const QKeySequence& shortcut, const std::function<void()>& slot) {
  QAction* action = menu->addAction(text, this, slot);
  action->setObjectName(QLatin1String(name));
  action->setParent(this);
  if (!shortcut.isEmpty()) {
    action->setShortcut(shortcut);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(text, shortcut.toString(QKeySequence::NativeText)));
  }
  return action;
}

QAction* MainWindow::addToggle(QMenu* menu, const char* name, const QString& text,
                               const QKeySequence& shortcut,
                               const std::function<void(bool)>& slot) {
  QAction* action = addAction(menu, name, text, shortcut, [] {});
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, slot);
  return action;
}

void MainWindow::buildMenus() {
  buildFileMenu();
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = models_->document.undoStack()->createUndoAction(this, tr("Undo"));
  undo->setObjectName("undo");
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = models_->document.undoStack()->createRedoAction(this, tr("Redo"));
  redo->setObjectName("redo");
  redo->setShortcut(QKeySequence::Redo);
  for (QAction* action : {undo, redo}) {
    // The text grows with the edit's name; a tool bar must not jump.
    action->setIconText(action == undo ? tr("Undo") : tr("Redo"));
    edit->addAction(action);
  }
  edit->addSeparator();
  addAction(edit, "clearSeeds", tr("Remove all seeds by hand"), {},
            [this] { models_->document.setField("seeds.points", std::vector<double>()); });
  addAction(edit, "clearRoi", tr("Clear region of interest"), {},
            [this] { models_->document.setRoi(std::nullopt); });
  buildRunMenu();
  buildToolMenu();
  buildPortMenu();
  buildViewMenu();
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  addAction(help, "shortcuts", tr("Shortcuts"), QKeySequence(Qt::Key_F1),
            [this] { showShortcuts(); });
  addAction(help, "about", tr("About Angiomesh"), {}, [this] { showAbout(); });
}

void MainWindow::buildFileMenu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  addAction(file, "open", tr("Open…"), QKeySequence::Open, [this] {
    if (const QString path = options_.chooser.openFile(this); !path.isEmpty()) {
      open(path);
    }
  });
  addAction(file, "openFolder", tr("Open folder or case…"), QKeySequence(tr("Ctrl+Shift+O")),
            [this] {
              if (const QString path = options_.chooser.openFolder(this); !path.isEmpty()) {
                open(path);
              }
            });
  addAction(file, "openSample", tr("Open the sample"), {}, [this] { openSample(); });
  recent_ = file->addMenu(tr("Recent"));
  file->addSeparator();
  addAction(file, "saveCase", tr("Save case"), QKeySequence::Save, [this] { saveCase(); });
  addAction(file, "saveCaseAs", tr("Save case as…"), QKeySequence(tr("Ctrl+Shift+S")),
            [this] { saveCaseAs(); });
  file->addSeparator();
  addAction(file, "export", tr("Export…"), QKeySequence(tr("Ctrl+E")), [this] { showExport(); });
  file->addSeparator();
  addAction(file, "quit", tr("Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::buildRunMenu() {
  QMenu* run = menuBar()->addMenu(tr("&Run"));
  addAction(run, "runAll", tr("Run"), QKeySequence(Qt::Key_F5), [this] { models_->runs.run(); });
  addAction(run, "cancelRun", tr("Cancel"), QKeySequence(Qt::Key_Escape),
            [this] { models_->cancel(); });
  run->addSeparator();
  addAction(run, "pauseRun", tr("Pause"), QKeySequence(Qt::Key_F6),
            [this] { models_->runs.setPaused(!models_->runs.paused()); });
  addAction(run, "stepRun", tr("Step"), QKeySequence(Qt::Key_F7),
            [this] { models_->runs.stepEvolution(kStepIterations); });
  addAction(run, "finishRun", tr("Finish"), QKeySequence(Qt::Key_F8),
            [this] { models_->runs.finishEvolution(); });
}

void MainWindow::buildToolMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Tools"));
  auto* tools = new QActionGroup(this);
  const auto tool = [&](const char* name, const QString& text, Qt::Key key, Tool which) {
    tools->addAction(addToggle(menu, name, text, QKeySequence(key),
                               [this, which](bool) { state_->setTool(which); }));
  };
  tool("toolNavigate", tr("Navigate"), Qt::Key_F2, Tool::Navigate);
  tool("toolSeed", tr("Pick seed"), Qt::Key_F3, Tool::PickSeed);
  tool("toolRoi", tr("Draw ROI"), Qt::Key_F4, Tool::DrawRoi);
  tool("toolCut", tr("Cut vessel"), Qt::Key_F9, Tool::CutVessel);
  menu->addSeparator();
  addToggle(menu, "engineering", tr("Left button moves the crosshair (Engineering)"),
            QKeySequence(tr("Ctrl+M")), [this](bool on) {
              state_->setScheme(on ? MouseScheme::Engineering : MouseScheme::Radiology);
            });
}

void MainWindow::buildViewMenu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  addToggle(view, "contours", tr("Contours"), QKeySequence(tr("Ctrl+L")),
            [this](bool on) { state_->setContours(on); });
  addToggle(view, "mip", tr("3D MIP"), QKeySequence(tr("Ctrl+I")),
            [this](bool on) { state_->setMip(on); });
  addToggle(view, "surface", tr("Surface"), QKeySequence(tr("Ctrl+U")),
            [this](bool on) { state_->setSurface(on); });
  addToggle(view, "edges", tr("Edges"), QKeySequence(tr("Ctrl+G")),
            [this](bool on) { state_->setEdges(on); });
  view->addSeparator();
  addAction(view, "resetWindow", tr("Reset window and level"), QKeySequence(tr("Ctrl+W")),
            [this] { state_->resetWindowLevel(); });
  addAction(view, "resetViews", tr("Reset all panes"), QKeySequence(tr("Ctrl+R")),
            [this] { views_->resetViews(); });
  view->addSeparator();
  const std::array<std::pair<const char*, QString>, 4> panes{{{"axial", tr("Axial alone")},
                                                              {"sagittal", tr("Sagittal alone")},
                                                              {"coronal", tr("Coronal alone")},
                                                              {"surface3d", tr("3D alone")}}};
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const QString name = QLatin1String(panes[i].first);
    addAction(view, qPrintable("maximise-" + name), panes[i].second,
              QKeySequence(QStringLiteral("Ctrl+%1").arg(i + 1)),
              [this, name] { views_->toggleMaximised(views_->findChild<QWidget*>(name)); });
  }
  view->addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    view->addAction(dock->toggleViewAction());
  }
}

void MainWindow::showExport() {
  auto* dialog = new ExportDialog(*models_, options_.chooser, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void MainWindow::showShortcuts() {
  auto* dialog = new QDialog(this);
  dialog->setObjectName("shortcutsDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Shortcuts"));
  dialog->resize(560, 640);
  auto* table = new QTableWidget(0, 2, dialog);
  table->setObjectName("shortcutsTable");
  table->setHorizontalHeaderLabels({tr("Key or mouse"), tr("What it does")});
  table->verticalHeader()->hide();
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  const auto add = [table](const QString& keys, const QString& what) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setItem(row, 0, new QTableWidgetItem(keys));
    table->setItem(row, 1, new QTableWidgetItem(what));
  };
  for (const QAction* action : findChildren<QAction*>()) {
    if (!action->shortcut().isEmpty()) {
      add(action->shortcut().toString(QKeySequence::NativeText), action->iconText());
    }
  }
  for (const auto& [keys, what] : paneShortcuts()) {
    add(QString::fromUtf8(keys), QString::fromUtf8(what));
  }
  table->resizeColumnsToContents();
  table->horizontalHeader()->setStretchLastSection(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(table);
  column->addWidget(buttons);
  dialog->open();
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, tr("About Angiomesh"),
      tr("Angiomesh %1\n\nFrom an angiogram to a vessel surface that a flow solver accepts.\n"
         "Not a medical device: research use only.\n\nBSD-3-Clause.")
          .arg(QString::fromLatin1(versionText())),
      QMessageBox::Close, this);
  box->setObjectName("aboutBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace angiomesh

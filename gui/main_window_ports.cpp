// SPDX-License-Identifier: BSD-3-Clause
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>

#include "gui/main_window.h"
#include "gui/model/case_ports.h"
#include "gui/panel/port_panel.h"
#include "gui/panel/view_grid.h"

namespace angiomesh {

namespace {

constexpr double kUsualRadii = 2.0, kMostRadii = 50.0;
constexpr int kButtonsPerRow = 3;

}  // namespace

void MainWindow::buildPortMenu() {
  QMenu* menu = menuBar()->addMenu(tr("P&orts"));
  // A copy of the name: the edit makes the rows anew.
  const auto onSelected = [this](auto edit) {
    return [this, edit] {
      if (const PortRow* row = ports_->selected()) {
        edit(QString(row->name));
      }
    };
  };
  QAction* cut = addAction(menu, "cutHere", tr("Cut here"), QKeySequence(tr("Ctrl+K")),
                           [this] { ports_->cutHere(views_->crosshair()); });
  cut->setToolTip(tr("Cuts the vessel at the crosshair (Ctrl+K)"));
  QAction* across = addAction(menu, "cutAcross", tr("Cut across"), QKeySequence(tr("Ctrl+Alt+K")),
                              onSelected([this](const QString& name) { ports_->cutAcross(name); }));
  across->setToolTip(
      tr("Ends the vessel across just inside an opening that slices it (Ctrl+Alt+K)"));
  QAction* ends = addAction(menu, "cutEnds", tr("Cut all ends…"), QKeySequence(tr("Ctrl+Shift+K")),
                            [this] { askForEnds(); });
  QAction* all =
      addAction(menu, "cutAllAcross", tr("Cut all across"), QKeySequence(tr("Ctrl+Alt+Shift+K")),
                [this] { ports_->cutAllAcross(); });
  all->setToolTip(tr("Ends all vessels across that the volume's border slices (Ctrl+Alt+Shift+K)"));
  menu->addSeparator();
  QAction* flip = addAction(menu, "flipPort", tr("Flip"), QKeySequence(tr("Ctrl+Shift+F")),
                            onSelected([this](const QString& name) { ports_->flip(name); }));
  flip->setToolTip(tr("Cuts away the other side (Ctrl+Shift+F)"));
  QAction* rename =
      addAction(menu, "renamePort", tr("Rename"), QKeySequence(tr("Ctrl+Shift+N")), [this] {
        if (const PortRow* row = ports_->selected()) {
          portPanel_->edit(row->name);
        }
      });
  QAction* remove = addAction(menu, "deletePort", tr("Delete"), QKeySequence(tr("Ctrl+Del")),
                              onSelected([this](const QString& name) { ports_->remove(name); }));
  menu->addSeparator();
  QAction* read = addAction(menu, "importPorts", tr("Import ports…"),
                            QKeySequence(tr("Ctrl+Shift+I")), [this] { importPorts(); });
  QAction* write = addAction(menu, "exportPorts", tr("Export ports…"),
                             QKeySequence(tr("Ctrl+Shift+E")), [this] { exportPorts(); });
  portPanel_->addButtons({cut, across, flip, ends, all, rename, read, write, remove},
                         kButtonsPerRow);
  connect(ports_, &CasePorts::changed, this, &MainWindow::refreshPortActions);
  connect(views_, &ViewGrid::menuRequested, this, &MainWindow::showPortMenu);
}

void MainWindow::refreshPortActions() {
  const PortRow* row = ports_->selected();
  const auto enable = [this](const char* name, bool on) {
    findChild<QAction*>(QLatin1String(name))->setEnabled(on);
  };
  for (const char* name : {"cutHere", "cutEnds", "cutAllAcross", "toolCut"}) {
    enable(name, ports_->ready());
  }
  for (const char* name : {"flipPort", "deletePort"}) {
    enable(name, row && row->cut);
  }
  enable("renamePort", row != nullptr);
  enable("cutAcross", row && row->across);
  enable("importPorts", models_->document.image() != nullptr);
  enable("exportPorts", !models_->results.ports(MeshKind::Exported).empty());
}

void MainWindow::showPortMenu(const QPoint& global, const std::optional<Eigen::Vector3d>& place,
                              const QString& port) {
  auto* menu = new QMenu(this);
  menu->setObjectName("portMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (port.isEmpty()) {
    QAction* cut =
        menu->addAction(tr("Cut here"), this, [this, place] { ports_->cutHere(*place); });
    cut->setEnabled(place.has_value() && ports_->ready());
  } else {
    ports_->select(port);
    menu->addSection(port);
    for (const char* name : {"cutAcross", "flipPort", "renamePort", "deletePort"}) {
      menu->addAction(findChild<QAction*>(QLatin1String(name)));
    }
  }
  menu->popup(global);
}

void MainWindow::askForEnds() {
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("endsDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Cut all ends"));
  dialog->setLabelText(
      tr("Each vessel that ends in the volume gets a cut, which can be edited.\n"
         "How far before its tip, in radii of the vessel:"));
  dialog->setInputMode(QInputDialog::DoubleInput);
  dialog->setDoubleRange(0.0, kMostRadii);
  dialog->setDoubleDecimals(1);
  dialog->setDoubleStep(0.5);
  dialog->setDoubleValue(kUsualRadii);
  connect(dialog, &QInputDialog::doubleValueSelected, ports_, &CasePorts::cutEnds);
  dialog->open();
}

void MainWindow::importPorts() {
  const QString path = options_.chooser.openPorts(this);
  if (!path.isEmpty()) {
    ports_->importPorts(path);
  }
}

void MainWindow::exportPorts() {
  QString path = options_.chooser.save(this, QStringLiteral("ports.json"), tr("Ports (*.json)"));
  if (path.isEmpty()) {
    return;
  }
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) {
    path += QStringLiteral(".json");
  }
  models_->exports.exportPorts(path);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/port_menu.h"

#include <QAction>
#include <QDockWidget>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <utility>

#include "gui/menu/window_actions.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr double kUsualRadii = 2.0, kMostRadii = 50.0;
constexpr int kButtonsPerRow = 3;

}  // namespace

PortMenu::PortMenu(QMainWindow* window, CaseModels& models, CasePorts& ports, PortPanel& panel,
                   ViewGrid& views, PathChooser chooser)
    : QObject(window),
      window_(window),
      models_(models),
      ports_(ports),
      panel_(panel),
      views_(views),
      chooser_(std::move(chooser)) {
  QMenu* menu = window->menuBar()->addMenu(tr("P&orts"));
  // A copy of the name: the edit makes the rows anew.
  const auto onSelected = [this](auto edit) {
    return [this, edit] {
      if (const PortRow* row = ports_.selected()) edit(QString(row->name));
    };
  };
  QAction* cut = addMenuAction(window, menu, "cutHere", tr("Cut here"), QKeySequence(tr("Ctrl+K")),
                               [this] { ports_.cutHere(views_.crosshair()); });
  cut->setToolTip(tr("Cuts the vessel at the crosshair (Ctrl+K)"));
  QAction* across =
      addMenuAction(window, menu, "cutAcross", tr("Cut across"), QKeySequence(tr("Ctrl+Alt+K")),
                    onSelected([this](const QString& name) { ports_.cutAcross(name); }));
  across->setToolTip(
      tr("Ends the vessel across just inside an opening that slices it (Ctrl+Alt+K)"));
  QAction* ends = addMenuAction(window, menu, "cutEnds", tr("Cut all ends…"),
                                QKeySequence(tr("Ctrl+Shift+K")), [this] { askForEnds(); });
  QAction* all =
      addMenuAction(window, menu, "cutAllAcross", tr("Cut all across"),
                    QKeySequence(tr("Ctrl+Alt+Shift+K")), [this] { ports_.cutAllAcross(); });
  all->setToolTip(tr("Ends all vessels across that the volume's border slices (Ctrl+Alt+Shift+K)"));
  menu->addSeparator();
  QAction* flip =
      addMenuAction(window, menu, "flipPort", tr("Flip"), QKeySequence(tr("Ctrl+Shift+F")),
                    onSelected([this](const QString& name) { ports_.flip(name); }));
  flip->setToolTip(tr("Cuts away the other side (Ctrl+Shift+F)"));
  QAction* rename = addMenuAction(window, menu, "renamePort", tr("Rename"),
                                  QKeySequence(tr("Ctrl+Shift+N")), [this] {
                                    if (const PortRow* row = ports_.selected())
                                      panel_.edit(row->name);
                                  });
  QAction* remove =
      addMenuAction(window, menu, "deletePort", tr("Delete"), QKeySequence(tr("Ctrl+Del")),
                    onSelected([this](const QString& name) { ports_.remove(name); }));
  menu->addSeparator();
  QAction* read = addMenuAction(window, menu, "importPorts", tr("Import ports…"),
                                QKeySequence(tr("Ctrl+Shift+I")), [this] { importPorts(); });
  QAction* write = addMenuAction(window, menu, "exportPorts", tr("Export ports…"),
                                 QKeySequence(tr("Ctrl+Shift+E")), [this] { exportPorts(); });
  panel_.addButtons({cut, across, flip, ends, all, rename, read, write, remove}, kButtonsPerRow);
  connect(&ports_, &CasePorts::changed, this, &PortMenu::refresh);
  connect(&views_, &ViewGrid::menuRequested, this, &PortMenu::show);
}

void PortMenu::refresh() {
  const PortRow* row = ports_.selected();
  enableActions(window_, {"cutHere", "cutEnds", "cutAllAcross", "toolCut"}, ports_.ready());
  enableActions(window_, {"flipPort", "deletePort"}, row && row->cut);
  enableActions(window_, {"renamePort"}, row != nullptr);
  enableActions(window_, {"cutAcross"}, row && row->across);
  enableActions(window_, {"importPorts"}, models_.document.image() != nullptr);
  enableActions(window_, {"exportPorts"}, !models_.results.ports(MeshKind::Exported).empty());
}

void PortMenu::show(const QPoint& global, const std::optional<Eigen::Vector3d>& place,
                    const QString& port, int plane) {
  auto* menu = named(new QMenu(window_), "portMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (port.isEmpty()) {
    QAction* cut = menu->addAction(tr("Cut here"), this, [this, place] { ports_.cutHere(*place); });
    cut->setEnabled(place.has_value() && ports_.ready());
  } else {
    ports_.select(port);
    menu->addSection(port);
    for (const char* name : {"cutAcross", "flipPort", "renamePort", "deletePort"})
      menu->addAction(actionOf(window_, name));
  }
  if (plane != ViewGrid::kNoSlice) {
    QAction* why = menu->addAction(tr("Why here?"), this, [this, place] {
      views_.setCrosshair(*place);
      auto* dock = window_->findChild<QDockWidget*>("whyDock");
      dock->show();
      dock->raise();
    });
    why->setEnabled(place.has_value());
  }
  Q_EMIT menuMade(menu, place, plane);
  menu->addAction(actionOf(window_, plane != ViewGrid::kNoSlice ? "windowMenu" : "volumeMenu"));
  menu->popup(global);
}

void PortMenu::askForEnds() {
  auto* dialog = named(new QInputDialog(window_), "endsDialog");
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
  connect(dialog, &QInputDialog::doubleValueSelected, &ports_, &CasePorts::cutEnds);
  dialog->open();
}

void PortMenu::importPorts() {
  const QString path = chooser_.openPorts(window_);
  if (!path.isEmpty()) ports_.importPorts(path);
}

void PortMenu::exportPorts() {
  QString path = chooser_.save(window_, QStringLiteral("ports.json"), tr("Ports (*.json)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) path += QStringLiteral(".json");
  models_.exports.exportPorts(path);
}

}  // namespace angiomesh

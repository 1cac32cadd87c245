// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QPoint>
#include <QString>
#include <optional>

#include "gui/dialog/export_dialog.h"
#include "gui/findings/case_ports.h"
#include "gui/pane/view_grid.h"
#include "gui/panel/port_panel.h"

class QMainWindow;
class QMenu;

namespace angiomesh {

/// What can be done with ports: the window's menu, the buttons of the list and the menu in a pane.
class PortMenu : public QObject {
  Q_OBJECT

 public:
  PortMenu(QMainWindow* window, CaseModels& models, CasePorts& ports, PortPanel& panel,
           ViewGrid& views, PathChooser chooser);

  void refresh();

 Q_SIGNALS:
  /// A menu of a pane was made, before it is shown; see ViewGrid::menuRequested().
  void menuMade(QMenu* menu, const std::optional<Eigen::Vector3d>& place, int plane);

 private:
  void show(const QPoint& global, const std::optional<Eigen::Vector3d>& place, const QString& port,
            int plane);
  void askForEnds();
  void importPorts();
  void exportPorts();

  QMainWindow* window_;
  CaseModels& models_;
  CasePorts& ports_;
  PortPanel& panel_;
  ViewGrid& views_;
  PathChooser chooser_;
};

}  // namespace angiomesh

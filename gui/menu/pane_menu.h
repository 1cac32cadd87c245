// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "gui/model/part_edits.h"
#include "gui/model/view_state.h"

class QMainWindow;
class QMenu;

namespace angiomesh {

class ViewGrid;

/// What the right-click menu of a pane has for that pane: its slab, or the part of the surface that
/// was clicked.
class PaneMenu : public QObject {
  Q_OBJECT

 public:
  PaneMenu(QMainWindow* window, ViewState& state, ViewGrid& views, PartEdits& parts);

  /// The entry that brings hidden parts back.
  void addTo(QMenu* viewMenu);

  /// See PortMenu::menuMade().
  void addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place, int plane);

 private:
  void addParts(QMenu* menu, const std::optional<Eigen::Vector3d>& place);
  void addSlab(QMenu* menu, int plane);

  QMainWindow* window_;
  ViewState& state_;
  ViewGrid& views_;
  PartEdits& parts_;
};

}  // namespace angiomesh

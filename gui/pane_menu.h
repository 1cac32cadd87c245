// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "gui/model/view_state.h"

class QMenu;

namespace angiomesh {

/// What the right-click menu of a pane says of how that pane is looked at.
class PaneMenu : public QObject {
  Q_OBJECT

 public:
  explicit PaneMenu(ViewState& state, QObject* parent = nullptr);

  /// See PortMenu::menuMade().
  void addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place, int plane);

 private:
  void addSlab(QMenu* menu, int plane);

  ViewState& state_;
};

}  // namespace angiomesh

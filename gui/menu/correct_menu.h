// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "gui/model/case_models.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"
#include "render/marks/measure_mark.h"

class QMainWindow;
class QMenu;
class QToolBar;

namespace angiomesh {

/// The menu of corrections, and what is seen of them in the panes while they are made.
class CorrectMenu : public QObject {
  Q_OBJECT

 public:
  CorrectMenu(QMainWindow* window, CaseModels& models, ViewState& state, ViewGrid& views);

  /// Puts the menu behind the other tools of a bar.
  void addTo(QToolBar* bar);
  /// Entries for a place, see PortMenu::menuMade().
  void addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place);

 private:
  void buildTools();
  void buildHere();
  void connectPanes();
  void refresh();
  void follow();
  void pick(const Eigen::Vector3d& place);
  /// The brush around a place, and what is painted so far, in the pane of a plane; in the others
  /// nothing.
  void sketch(int plane, const std::vector<Eigen::Vector3d>& line);
  void clearSketch();

  QMainWindow* window_;
  CaseModels& models_;
  ViewState& state_;
  ViewGrid& views_;
  QMenu* menu_;
  Tool tool_ = Tool::Navigate;
  bool drawing_ = false;
  int sketched_ = ViewGrid::kNoSlice;  ///< the plane whose pane shows a sketch
};

}  // namespace angiomesh

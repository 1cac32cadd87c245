// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "gui/dialog/export_dialog.h"
#include "gui/findings/case_measures.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"
#include "gui/panel/measure_panel.h"
#include "render/marks/measure_mark.h"

class QMainWindow;
class QMenu;
class QToolBar;

namespace angiomesh {

/// The menu of measurements, whose tools are buttons of their panel too, and what of them is seen
/// and picked in the panes.
class MeasureMenu : public QObject {
  Q_OBJECT

 public:
  MeasureMenu(QMainWindow* window, CaseModels& models, ViewState& state, CaseMeasures& measures,
              MeasurePanel& panel, ViewGrid& views, PathChooser chooser);

  /// Puts the menu behind the other tools of a bar.
  void addTo(QToolBar* bar);
  /// Entries that begin at a place, see PortMenu::menuMade().
  void addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place);

 private:
  void buildTools();
  void buildEdits();
  void connectPanes();
  void connectDragging(const SliceView* pane);
  void refresh();
  void follow();
  void showMarks();
  void showBand(int plane, const Eigen::Vector3d& to);
  void exportTable();

  QMainWindow* window_;
  CaseModels& models_;
  ViewState& state_;
  CaseMeasures& measures_;
  MeasurePanel& panel_;
  ViewGrid& views_;
  PathChooser chooser_;
  QMenu* menu_;
  Tool tool_ = Tool::Navigate;
  std::vector<MeasureMark> shown_;
  std::optional<MarkPoint> dragged_;  ///< a place on its way elsewhere
  bool dropped_ = false;              ///< it is there, and being measured
};

}  // namespace angiomesh

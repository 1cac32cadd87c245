// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <utility>
#include <vector>

#include "gui/model/case_models.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"

class QComboBox;
class QDoubleSpinBox;
class QMainWindow;
class QMenu;
class QToolBar;

namespace angiomesh {

class PaneTools;

/// How the panes are looked at: the menus Tools and View, and the tool bar.
class ViewTools : public QObject {
  Q_OBJECT

 public:
  ViewTools(QMainWindow* window, CaseModels& models, ViewState& state, ViewGrid& views);

  // Each is built once, in the order that the window has them in.
  void buildToolMenu();
  void addTo(QMenu* viewMenu);
  /// Two rows, which take actions of the other menus too. @returns the upper one
  QToolBar* buildToolBars();

  /// Gives the actions of the tool bars their icons. Called once all are on them.
  void addIcons();

  /// What can be chosen, by what there is to see.
  void refresh();
  /// What is chosen.
  void refreshActions();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addThemes(QMenu* viewMenu);
  void addLanguages(QMenu* viewMenu);
  void fitToolBars();
  QToolBar* addBar(const char* name, const QString& title);
  void addPanes(QMenu* viewMenu);
  void buildChoosers(QToolBar* bar);
  [[nodiscard]] bool anySlab() const;
  void setThickness(double mm);
  void recallPanes();
  void rememberPanes() const;

  QMainWindow* window_;
  std::vector<std::pair<QToolBar*, int>> bars_;  ///< with their widths in pixels, with all text
  CaseModels& models_;
  ViewState& state_;
  ViewGrid& views_;
  PaneTools* panes_;
  QComboBox* layer_ = nullptr;
  QComboBox* slab_ = nullptr;
  QDoubleSpinBox* thickness_ = nullptr;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <string>
#include <utility>
#include <vector>

#include "gui/model/view_state.h"

class QMainWindow;
class QMenu;

namespace angiomesh {

/// The menu of window and level: presets, numbers, and what the layer begins with. Its action is
/// "windowMenu", for other menus.
class WindowMenu : public QObject {
  Q_OBJECT

 public:
  WindowMenu(QMainWindow* window, QMenu* parent, CaseModels& models, ViewState& state);

 private:
  void refresh();
  void refreshOthers();
  void showDialog();

  QMainWindow* window_;
  CaseModels& models_;
  ViewState& state_;
  QMenu* others_;
  std::vector<std::pair<WindowLevel, std::string>> listed_;  ///< in others_
};

}  // namespace angiomesh

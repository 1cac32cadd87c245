// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStackedWidget>

#include "gui/model/case_models.h"
#include "gui/pane/view_grid.h"

class QMainWindow;
class QPushButton;

namespace angiomesh {

class Banner;
class WelcomePage;

/// The middle of the window: the panes, or a page to begin with while nothing is open; and over
/// both what went wrong.
class CentralArea : public QStackedWidget {
  Q_OBJECT

 public:
  CentralArea(CaseModels& models, ViewGrid* views, QWidget* parent = nullptr);

  /// Puts actions of the window's menus on the page and the banner. Called once, after the menus.
  void addActionsOf(const QMainWindow* window);
  void setRecent(const QStringList& paths);

 Q_SIGNALS:
  void openRequested(const QString& path);

 private:
  void showWhatThereIs();

  CaseModels& models_;
  ViewGrid* views_;
  WelcomePage* welcome_;
  Banner* banner_;
  QList<QPushButton*> openNext_;  ///< of use when something could not be opened
};

}  // namespace angiomesh

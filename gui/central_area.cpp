// SPDX-License-Identifier: BSD-3-Clause
#include "gui/central_area.h"

#include <QAction>
#include <QMainWindow>
#include <QPushButton>

#include "gui/banner.h"
#include "gui/menu/window_actions.h"
#include "gui/welcome_page.h"

namespace angiomesh {

CentralArea::CentralArea(CaseModels& models, ViewGrid* views, QWidget* parent)
    : QStackedWidget(parent),
      models_(models),
      views_(views),
      welcome_(new WelcomePage(this)),
      banner_(new Banner(this)) {
  addWidget(welcome_);
  addWidget(views_);
  connect(welcome_, &WelcomePage::openRequested, this, &CentralArea::openRequested);
  connect(&models_.files, &CaseFiles::caseChanged, this, &CentralArea::showWhatThereIs);
  connect(&models_.files, &CaseFiles::loadingChanged, this, [this] {
    if (models_.files.loading()) banner_->hide();
  });
  connect(&models_.runs, &RunModel::statesChanged, this, [this] {
    if (models_.runs.running()) banner_->hide();
  });
  connect(&models_.log, &MessageLog::message, this, [this](Severity severity, const QString& text) {
    if (severity != Severity::Error) return;
    for (QPushButton* button : openNext_) button->setVisible(!models_.document.hasCase());
    banner_->tell(text);
  });
  showWhatThereIs();
}

void CentralArea::addActionsOf(const QMainWindow* window) {
  welcome_->addButton(actionOf(window, "open"), tr("Open file…"));
  welcome_->addButton(actionOf(window, "openFolder"), tr("Open DICOM folder…"));
  welcome_->addButton(actionOf(window, "openSample"), tr("Try the sample"));
  for (const char* name : {"open", "openFolder"})
    openNext_ << banner_->addButton(actionOf(window, name));
  banner_->addButton(actionOf(window, "showLog"));
}

void CentralArea::setRecent(const QStringList& paths) { welcome_->setRecent(paths); }

void CentralArea::showWhatThereIs() {
  if (models_.document.hasCase())
    setCurrentWidget(views_);
  else
    setCurrentWidget(welcome_);
}

}  // namespace angiomesh

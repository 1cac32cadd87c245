// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/volume_menu.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <array>

#include "gui/menu/window_actions.h"

namespace angiomesh {

namespace {

struct Entry {
  VolumeView view;
  const char* action;
  const char* title;
  const char* key;
};

constexpr std::array<Entry, 3> kEntries{
    {{VolumeView::Mip, "mip", QT_TRANSLATE_NOOP("angiomesh::VolumeMenu", "3D MIP"), "Ctrl+I"},
     {VolumeView::MrAngio, "volumeMr",
      QT_TRANSLATE_NOOP("angiomesh::VolumeMenu", "Shaded, MR angiography"), "Ctrl+Shift+V"},
     {VolumeView::CtAngio, "volumeCt",
      QT_TRANSLATE_NOOP("angiomesh::VolumeMenu", "Shaded, CT angiography"), "Ctrl+Shift+T"}}};

}  // namespace

VolumeMenu::VolumeMenu(QMainWindow* window, QMenu* parent, CaseModels& models, ViewState& state)
    : QObject(window), window_(window), models_(models), state_(state) {
  QMenu* menu = parent->addMenu(tr("Volume in 3D"));
  menu->menuAction()->setObjectName("volumeMenu");
  for (const Entry& entry : kEntries)
    addMenuToggle(
        window_, menu, entry.action, tr(entry.title), QKeySequence(QLatin1String(entry.key)),
        [this, view = entry.view](bool on) { state_.setVolumeView(on ? view : VolumeView::None); });
  menu->addSeparator();
  addMenuToggle(window_, menu, "resultBeside", tr("Result beside the image"),
                QKeySequence(tr("Ctrl+Shift+B")), [this](bool on) { state_.setResultBeside(on); });
  connect(&state_, &ViewState::changed, this, &VolumeMenu::refresh);
  connect(&models_.files, &CaseFiles::caseChanged, this, &VolumeMenu::refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, &VolumeMenu::refresh);
  refresh();
}

void VolumeMenu::refresh() {
  for (const Entry& entry : kEntries)
    actionOf(window_, entry.action)->setChecked(state_.volumeView() == entry.view);
  const bool any = models_.document.hasCase();
  enableActions(window_, {"mip", "volumeMr"}, any);
  enableActions(window_, {"volumeCt"}, any && state_.suitsCt());
  actionOf(window_, "resultBeside")->setChecked(state_.resultBeside());
  enableActions(window_, {"resultBeside"}, any);
}

}  // namespace angiomesh

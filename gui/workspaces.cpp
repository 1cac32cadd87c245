// SPDX-License-Identifier: BSD-3-Clause
#include "gui/workspaces.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QToolBar>
#include <algorithm>

#include "gui/menu/window_actions.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// Layouts of another number are not restored: to be raised when docks or tool bars change names.
constexpr int kLayoutVersion = 1;
const QString kCurrentKey = QStringLiteral("workspace/current");

struct WorkspaceFacts {
  const char* id;
  const char* action;
  const char* title;
  const char* purpose;
  Qt::Key key;
  QStringList docks;
};

const WorkspaceFacts& factsOf(Workspace workspace) {
  static const std::array<WorkspaceFacts, kWorkspaceCount> table{
      {{"review",
        "workspaceReview",
        QT_TRANSLATE_NOOP("angiomesh::Workspaces", "Review"),
        QT_TRANSLATE_NOOP("angiomesh::Workspaces", "The images, with nothing beside them"),
        Qt::Key_F1,
        {}},
       {"tune",
        "workspaceTune",
        QT_TRANSLATE_NOOP("angiomesh::Workspaces", "Tune"),
        QT_TRANSLATE_NOOP("angiomesh::Workspaces", "The steps of the pipeline and the convergence"),
        Qt::Key_F2,
        {"pipelineDock", "convergenceDock"}},
       {"mesh",
        "workspaceMesh",
        QT_TRANSLATE_NOOP("angiomesh::Workspaces", "Mesh"),
        QT_TRANSLATE_NOOP("angiomesh::Workspaces", "The mesh inspector, the ports and the log"),
        Qt::Key_F3,
        {"inspectorDock", "portsDock", "logDock"}}}};
  return table[static_cast<std::size_t>(workspace)];
}

const QString kGeometryKey = QStringLiteral("workspace/window");

QString layoutKey(Workspace workspace) {
  return QStringLiteral("workspace/layout/") + QLatin1String(factsOf(workspace).id);
}

}  // namespace

Workspaces::Workspaces(QMainWindow* window) : QObject(window), window_(window) {}

void Workspaces::addTo(QMenu* menu) {
  auto* group = new QActionGroup(this);
  for (int i = 0; i < kWorkspaceCount; ++i) {
    const auto workspace = static_cast<Workspace>(i);
    const WorkspaceFacts& facts = factsOf(workspace);
    const QKeySequence keys(Qt::CTRL | facts.key);
    QAction* action = addMenuToggle(window_, menu, facts.action, tr(facts.title), keys,
                                    [this, workspace](bool) { choose(workspace); });
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(tr(facts.purpose), keys.toString(QKeySequence::NativeText)));
    group->addAction(action);
    actions_[static_cast<std::size_t>(i)] = action;
  }
  addMenuAction(window_, menu, "resetWorkspace", tr("Reset this workspace"), {},
                [this] { reset(); });
}

void Workspaces::addTo(QToolBar* bar) {
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  for (QAction* action : actions_) bar->addAction(action);
}

void Workspaces::start() {
  allDocks_ = window_->saveState(kLayoutVersion);
  // Qt moves it to where a screen is.
  window_->restoreGeometry(QSettings().value(kGeometryKey).toByteArray());
  const QString last = QSettings().value(kCurrentKey).toString();
  Workspace first = Workspace::Review;
  for (int i = 0; i < kWorkspaceCount; ++i)
    if (last == QLatin1String(factsOf(static_cast<Workspace>(i)).id))
      first = static_cast<Workspace>(i);
  show(first);
}

void Workspaces::choose(Workspace workspace) {
  if (workspace == current_) return;
  remember();
  show(workspace);
  remember();
}

void Workspaces::show(Workspace workspace) {
  current_ = workspace;
  actions_[static_cast<std::size_t>(workspace)]->setChecked(true);
  // One that the version did not have that kept the layout stays away.
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) dock->hide();
  const QByteArray layout = QSettings().value(layoutKey(workspace)).toByteArray();
  if (layout.isEmpty() || !window_->restoreState(layout, kLayoutVersion)) reset();
}

void Workspaces::reset() {
  window_->restoreState(allDocks_, kLayoutVersion);
  const QStringList& wanted = factsOf(current_).docks;
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>())
    dock->setVisible(wanted.contains(dock->objectName()));
}

void Workspaces::remember() const {
  QSettings settings;
  settings.setValue(kCurrentKey, QLatin1String(factsOf(current_).id));
  settings.setValue(layoutKey(current_), window_->saveState(kLayoutVersion));
  settings.setValue(kGeometryKey, window_->saveGeometry());
}

}  // namespace angiomesh

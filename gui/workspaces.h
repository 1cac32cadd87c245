// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QObject>
#include <array>

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace angiomesh {

enum class Workspace { Review, Tune, Mesh };
constexpr int kWorkspaceCount = 3;

/// Which docks are open for which work. Each workspace comes back as the user left it, also at the
/// next start.
class Workspaces : public QObject {
  Q_OBJECT

 public:
  explicit Workspaces(QMainWindow* window);

  /// The entries that choose and reset a workspace.
  void addTo(QMenu* menu);
  /// The buttons that choose one, at the right end.
  void addTo(QToolBar* bar);
  /// Opens the workspace of the last time, at first Review. Called once, when the window has its
  /// docks, menus and tool bars.
  void start();

  [[nodiscard]] Workspace current() const { return current_; }
  void choose(Workspace workspace);
  /// Opens the docks that the present workspace has at first, where they are at first.
  void reset();
  /// Keeps the present workspace for the next start.
  void remember() const;

 private:
  void show(Workspace workspace);

  QMainWindow* window_;
  std::array<QAction*, kWorkspaceCount> actions_{};
  QByteArray allDocks_;  ///< the layout with every dock at its first place
  Workspace current_ = Workspace::Review;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStringList>
#include <QWidget>

class QAction;
class QLabel;
class QListWidget;
class QVBoxLayout;

namespace angiomesh {

/// What the window shows instead of empty panes: what the program is, and ways to begin.
class WelcomePage : public QWidget {
  Q_OBJECT

 public:
  explicit WelcomePage(QWidget* parent = nullptr);

  /// A button that does what the action does, under a text of its own.
  void addButton(QAction* action, const QString& text);
  /// Files, folders and cases to open again, the latest first.
  void setRecent(const QStringList& paths);

 Q_SIGNALS:
  void openRequested(const QString& path);

 private:
  QVBoxLayout* buttons_;
  QLabel* recentTitle_;
  QListWidget* recent_;
};

}  // namespace angiomesh

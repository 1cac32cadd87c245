// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QUrl>

class QLineEdit;
class QListWidget;
class QStackedWidget;
class QTableWidget;

namespace angiomesh {

class GuidePage;

/// The pages of docs/ that a user needs, beside the list of shortcuts. Not modal: it stays open
/// beside the window.
class Guide : public QDialog {
  Q_OBJECT

 public:
  /// @param window whose actions have the shortcuts
  explicit Guide(QWidget* window);

  void showPage(const QString& name);  ///< "desktop"; empty: the shortcuts

 private:
  QTableWidget* shortcutsOf(const QWidget* window);
  void choose(int row);
  void follow(const QUrl& page);
  void findNext();

  QListWidget* list_;
  QStackedWidget* stack_;
  GuidePage* text_;
  QLineEdit* wanted_;
};

/// Opens the guide of a window, or brings it to the front, at a page.
void showGuide(QWidget* window, const QString& page);

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>

class QAction;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace angiomesh {

/// What went wrong, over the middle of its parent, until it is closed or of no more use.
class Banner : public QFrame {
  Q_OBJECT

 public:
  explicit Banner(QWidget* parent);

  /// A button that does what the action does.
  QPushButton* addButton(QAction* action);
  void tell(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QLabel* text_;
  QHBoxLayout* buttons_;
};

}  // namespace angiomesh

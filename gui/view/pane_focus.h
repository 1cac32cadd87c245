// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QWidget>

namespace angiomesh {

/// Gives the keyboard to the pane that the mouse enters, unless somebody types elsewhere: an editor
/// was reached by the keyboard or by a click into its text, and neither Return nor Escape came
/// since.
class PaneFocus : public QObject {
  Q_OBJECT

 public:
  explicit PaneFocus(const QList<QWidget*>& panes, QObject* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void noteKey(QWidget* editor, const QKeyEvent& key);

  QList<QWidget*> panes_;
  QPointer<QWidget> typing_;  ///< the editor; counts while it has the focus
};

}  // namespace angiomesh

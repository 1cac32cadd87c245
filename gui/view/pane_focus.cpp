// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/pane_focus.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>

namespace angiomesh {

namespace {

/// The widget that has the focus while text is entered into `object`; null: none can be.
QWidget* editorOf(QObject* object) {
  if (auto* spin = qobject_cast<QAbstractSpinBox*>(object)) return spin;
  auto* line = qobject_cast<QLineEdit*>(object);
  if (!line || line->isReadOnly()) return nullptr;
  return line->focusProxy() ? line->focusProxy() : line;
}

}  // namespace

PaneFocus::PaneFocus(const QList<QWidget*>& panes, QObject* parent)
    : QObject(parent), panes_(panes) {
  QApplication::instance()->installEventFilter(this);
}

bool PaneFocus::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
      if (auto* pane = qobject_cast<QWidget*>(watched); pane && panes_.contains(pane))
        if (!typing_ || typing_ != QApplication::focusWidget())
          pane->setFocus(Qt::MouseFocusReason);
      break;
    case QEvent::MouseButtonPress:
      // Into the text: the arrows of a spin box are not in its line.
      if (qobject_cast<QLineEdit*>(watched)) typing_ = editorOf(watched);
      break;
    case QEvent::FocusIn: {
      const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
      const bool asked = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
                         reason == Qt::ShortcutFocusReason || reason == Qt::OtherFocusReason;
      if (QWidget* editor = editorOf(watched); editor && asked) typing_ = editor;
      break;
    }
    case QEvent::KeyPress:
      if (QWidget* editor = editorOf(watched)) noteKey(editor, *static_cast<QKeyEvent*>(event));
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void PaneFocus::noteKey(QWidget* editor, const QKeyEvent& key) {
  const bool ends =
      key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Escape;
  if (ends)
    typing_ = nullptr;
  else if (!key.text().isEmpty())
    typing_ = editor;
}

}  // namespace angiomesh

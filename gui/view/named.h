// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QScrollArea>
#include <QString>
#include <QWidget>

namespace angiomesh {

/// The object under a name that tests and the saved layout know it by.
template <class Object>
Object* named(Object* object, const QString& name) {
  object->setObjectName(name);
  return object;
}

/// What is too high for it scrolls; its width is that of the column in it.
inline QScrollArea* columnScroll(QWidget* parent) {
  auto* scroll = new QScrollArea(parent);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return scroll;
}

/// Keeps the room of a widget that comes and goes, so that nothing beside it moves.
inline void keepRoom(QWidget* widget) {
  QSizePolicy policy = widget->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  widget->setSizePolicy(policy);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractItemView>
#include <QGraphicsOpacityEffect>

namespace angiomesh {

/// Shows a widget faintly, as what is out of date; it can be used all the same.
inline void setDimmed(QWidget* widget, bool dimmed) {
  if (auto* table = qobject_cast<QAbstractItemView*>(widget)) {
    // An effect does not reach what a scroll area shows.
    QPalette palette;
    if (dimmed) palette.setColor(QPalette::Text, palette.color(QPalette::Disabled, QPalette::Text));
    table->setPalette(palette);
    return;
  }
  if (dimmed == (widget->graphicsEffect() != nullptr)) return;
  auto* faint = dimmed ? new QGraphicsOpacityEffect(widget) : nullptr;
  if (faint != nullptr) faint->setOpacity(0.45);
  widget->setGraphicsEffect(faint);
}

}  // namespace angiomesh

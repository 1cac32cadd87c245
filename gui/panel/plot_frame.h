// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPainter>
#include <QPalette>
#include <QRectF>

namespace angiomesh {

/// Of axes and grids.
inline QColor faintColour(const QPalette& palette) {
  QColor colour = palette.color(QPalette::Text);
  colour.setAlpha(60);
  return colour;
}

/// The two axes of a plot.
inline void drawPlotFrame(QPainter& painter, const QRectF& area, const QPalette& palette) {
  painter.setPen(faintColour(palette));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.drawLine(area.bottomLeft(), area.topLeft());
}

}  // namespace angiomesh

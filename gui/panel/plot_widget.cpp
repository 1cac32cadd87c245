// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/plot_widget.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/model/case_models.h"
#include "gui/model/step_text.h"
#include "gui/panel/plot_frame.h"

namespace angiomesh {

namespace {

constexpr int kMargin = 6;

/// Outlines are told apart by their dashes, and follow the palette.
QPen outlinePen(MeshKind kind, const QPalette& palette) {
  QPen pen(palette.color(QPalette::Text), 1.4);
  if (kind == MeshKind::Exported)
    pen.setColor(palette.color(QPalette::Highlight));
  else if (kind == MeshKind::Unsmoothed)
    pen.setStyle(Qt::DashLine);
  else
    pen.setStyle(Qt::DotLine);
  return pen;
}

}  // namespace

HistogramWidget::HistogramWidget(QString title, double from, double to, int bins, QWidget* parent)
    : QWidget(parent), title_(std::move(title)), from_(from), to_(to), bins_(bins) {
  setMinimumHeight(120);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void HistogramWidget::setValues(MeshKind kind, const std::vector<float>& values) {
  std::vector<double>& shares = shares_[static_cast<std::size_t>(kind)];
  shares.assign(values.empty() ? 0 : static_cast<std::size_t>(bins_), 0.0);
  for (const float value : values) {
    const int bin = static_cast<int>((value - from_) / (to_ - from_) * bins_);
    shares[static_cast<std::size_t>(std::clamp(bin, 0, bins_ - 1))] +=
        100.0 / static_cast<double>(values.size());
  }
  update();
}

void HistogramWidget::setSelected(MeshKind kind) {
  selected_ = kind;
  update();
}

const std::vector<double>& HistogramWidget::shares(MeshKind kind) const {
  return shares_[static_cast<std::size_t>(kind)];
}

void HistogramWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QFontMetrics metrics = painter.fontMetrics();
  const int line = metrics.height();
  const QRectF area(kMargin + 4, kMargin + line + 4, width() - 2 * kMargin - 8,
                    height() - 2 * kMargin - 2 * line - 6);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(kMargin, kMargin + metrics.ascent(), title_);
  drawPlotFrame(painter, area, palette());
  double top = 0.0;
  for (const std::vector<double>& shares : shares_)
    for (const double share : shares) top = std::max(top, share);
  if (top <= 0.0) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(area, Qt::AlignCenter, tr("No mesh yet"));
    return;
  }
  paintBars(painter, area, selected_, top);
  for (int kind = 0; kind < kMeshKindCount; ++kind)
    if (static_cast<MeshKind>(kind) != selected_)
      paintBars(painter, area, static_cast<MeshKind>(kind), top);
  painter.setPen(palette().color(QPalette::Text));
  for (int tick = 0; tick <= 3; ++tick) {
    const double x = area.left() + tick / 3.0 * area.width();
    const QString text = QString::number(from_ + tick / 3.0 * (to_ - from_), 'g', 2);
    const double half = metrics.horizontalAdvance(text) / 2.0;
    painter.drawText(QPointF(std::clamp(x - half, area.left(), area.right() - 2 * half),
                             area.bottom() + metrics.ascent() + 2),
                     text);
  }
  paintLegend(painter, area);
}

void HistogramWidget::paintBars(QPainter& painter, const QRectF& area, MeshKind kind,
                                double top) const {
  const std::vector<double>& values = shares(kind);
  if (values.empty()) return;
  QPainterPath path(area.bottomLeft());
  for (int bin = 0; bin < bins_; ++bin) {
    const double y = area.bottom() - values[static_cast<std::size_t>(bin)] / top * area.height();
    path.lineTo(area.left() + area.width() * bin / bins_, y);
    path.lineTo(area.left() + area.width() * (bin + 1) / bins_, y);
  }
  path.lineTo(area.bottomRight());
  if (kind == selected_) {
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlpha(110);
    painter.fillPath(path, fill);
  }
  painter.setPen(outlinePen(kind, palette()));
  painter.drawPath(path);
}

void HistogramWidget::paintLegend(QPainter& painter, const QRectF& area) const {
  const QFontMetrics metrics = painter.fontMetrics();
  double y = area.top() + 2;
  for (int i = 0; i < kMeshKindCount; ++i) {
    const auto kind = static_cast<MeshKind>(i);
    if (shares(kind).empty()) continue;
    const QRectF text(area.left() + 34, y, area.width() - 34, metrics.height());
    painter.setPen(outlinePen(kind, palette()));
    painter.drawLine(QPointF(area.left() + 8, text.center().y()),
                     QPointF(area.left() + 28, text.center().y()));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, meshTitle(kind));
    y += metrics.height();
  }
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/histogram_widget.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

constexpr int kMargin = 6;
const QColor kLitColour(0, 150, 130);

/// Outlines are told apart by their dashes, and follow the palette.
QPen outlinePen(MeshKind kind, const QPalette& palette) {
  QPen pen(palette.color(QPalette::Text), 1.4);
  if (kind == MeshKind::Exported)
    pen.setColor(palette.color(QPalette::Highlight));
  else if (kind == MeshKind::Unsmoothed)
    pen.setStyle(Qt::DashLine);
  else
    pen.setStyle(kind == MeshKind::MarchingCubes ? Qt::DotLine : Qt::DashDotLine);
  return pen;
}

/// 1, 2 or 5 times a power of ten: about `parts` of them in a range.
double niceStep(double range, double parts) {
  const double raw = range / parts;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double step : {1.0, 2.0, 5.0})
    if (raw <= step * power) return step * power;
  return 10.0 * power;
}

QColor faded(QColor colour, int alpha) {
  colour.setAlpha(alpha);
  return colour;
}

}  // namespace

HistogramWidget::HistogramWidget(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(160);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMouseTracking(true);
}

void HistogramWidget::setMeasured(std::shared_ptr<const MeasuredMeshes> measured) {
  measured_ = std::move(measured);
  pressed_.reset();
  update();
}

void HistogramWidget::setSelected(MeshKind kind) {
  selected_ = kind;
  update();
}

void HistogramWidget::setLit(const std::optional<std::pair<int, int>>& bars) {
  lit_ = bars;
  update();
}

const std::vector<double>& HistogramWidget::shares(MeshKind kind) const {
  static const std::vector<double> none;
  return measured_ ? measured_->of(kind).shares : none;
}

QRectF HistogramWidget::plotArea() const {
  const QFontMetrics metrics = fontMetrics();
  const double left = kMargin + metrics.horizontalAdvance("100 %") + 6;
  const double top = kMargin + 2.0 * metrics.height() + 6;
  return {left, top, std::max(1.0, width() - left - 2 * kMargin),
          std::max(1.0, height() - top - kMargin - metrics.height() - 4)};
}

double HistogramWidget::xOf(double value) const {
  const QRectF area = plotArea();
  return area.left() + (value - measured_->from) / (measured_->to - measured_->from) * area.width();
}

QRectF HistogramWidget::barArea(int bar) const {
  const QRectF area = plotArea();
  const double width = area.width() / std::max(1, measured_ ? measured_->bars : 1);
  return {area.left() + bar * width, area.top(), width, area.height()};
}

std::optional<int> HistogramWidget::barAt(const QPointF& place) const {
  const QRectF area = plotArea();
  if (!measured_ || !area.adjusted(-2, -2, 2, 2).contains(place)) return std::nullopt;
  const double at = (place.x() - area.left()) / area.width() * measured_->bars;
  return std::clamp(static_cast<int>(at), 0, measured_->bars - 1);
}

double HistogramWidget::highest() const {
  double top = 0.0;
  for (int kind = 0; kind < kMeshKindCount; ++kind)
    for (const double share : shares(static_cast<MeshKind>(kind))) top = std::max(top, share);
  return top;
}

void HistogramWidget::mousePressEvent(QMouseEvent* event) {
  const std::optional<int> bar = barAt(event->position());
  if (event->button() != Qt::LeftButton || !bar) return;
  pressed_ = bar;
  if (lit_ && *bar >= lit_->first && *bar <= lit_->second) {
    pressed_.reset();
    Q_EMIT barsPicked(std::nullopt);
    return;
  }
  Q_EMIT barsPicked(std::pair(*bar, *bar));
}

void HistogramWidget::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<int> bar = barAt(event->position());
  if (!bar) return;
  showTip(event->globalPosition().toPoint(), *bar);
  if (pressed_ && event->buttons().testFlag(Qt::LeftButton))
    Q_EMIT barsPicked(std::pair(std::min(*pressed_, *bar), std::max(*pressed_, *bar)));
}

void HistogramWidget::mouseReleaseEvent(QMouseEvent* /*event*/) { pressed_.reset(); }

void HistogramWidget::showTip(const QPoint& global, int bar) {
  const double width = (measured_->to - measured_->from) / measured_->bars;
  const TriangleMeasure& measure = *measured_->measure;
  const double from = measured_->from + bar * width;
  const QString range =
      measure.digits == 0
          ? measureValue(measure, from + 0.5 * width)
          : tr("%1 to %2").arg(measureValue(measure, from), measureValue(measure, from + width));
  QStringList lines{range + ' ' + unitText(measure.unit)};
  for (int i = 0; i < kMeshKindCount; ++i) {
    const auto kind = static_cast<MeshKind>(i);
    if (!shares(kind).empty())
      lines << tr("%1: %2 %")
                   .arg(meshTitle(kind))
                   .arg(shares(kind)[static_cast<std::size_t>(bar)], 0, 'f', 2);
  }
  QToolTip::showText(global, lines.join('\n'), this);
}

void HistogramWidget::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QRectF area = plotArea();
  const double top = highest();
  if (top <= 0.0) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter, tr("No mesh yet"));
    return;
  }
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(kMargin, kMargin + painter.fontMetrics().ascent(),
                   tr("%1 (% of triangles)").arg(measureTitle(*measured_->measure)));
  paintScales(painter, area, top);
  paintBars(painter, area, selected_, top);
  for (int kind = 0; kind < kMeshKindCount; ++kind)
    if (static_cast<MeshKind>(kind) != selected_)
      paintBars(painter, area, static_cast<MeshKind>(kind), top);
  paintLimits(painter, area);
  paintLegend(painter, area);
}

void HistogramWidget::paintScales(QPainter& painter, const QRectF& area, double top) const {
  const QFontMetrics metrics = painter.fontMetrics();
  const QColor text = palette().color(QPalette::Text);
  const QColor line = faded(text, 60);
  const double step = niceStep(top, 4.0);
  for (double share = 0.0; share <= top * 1.0001; share += step) {
    const double y = area.bottom() - share / top * area.height();
    painter.setPen(line);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0, y - metrics.height() / 2.0, area.left() - 4, metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(share, 'g', 3));
  }
  painter.setPen(line);
  painter.drawLine(area.bottomLeft(), area.topLeft());
  const double from = measured_->from, to = measured_->to;
  const double tick =
      measured_->measure->digits == 0 ? 1.0 : niceStep(to - from, area.width() / 60.0);
  double last = -1e9;
  for (double value = std::ceil(from / tick - 1e-9) * tick; value <= to + 1e-9 * tick;
       value += tick) {
    const double x = xOf(value);
    painter.setPen(faded(text, 140));
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 3));
    const QString number = QString::number(std::abs(value) < 1e-9 * tick ? 0.0 : value, 'g', 4);
    const double half = metrics.horizontalAdvance(number) / 2.0;
    if (x - half < last) continue;
    last = x + half + 4;
    painter.setPen(text);
    painter.drawText(
        QPointF(std::min(x - half, width() - 2 * half - 1), area.bottom() + metrics.ascent() + 4),
        number);
  }
}

void HistogramWidget::paintLimits(QPainter& painter, const QRectF& area) const {
  const QFontMetrics metrics = painter.fontMetrics();
  double free = 0.0;  // where the next name has room
  for (const BandLimit& limit : bandLimits(*measured_->measure)) {
    if (limit.at < measured_->from || limit.at > measured_->to) continue;
    // Between bars, where these are whole numbers.
    const TriangleMeasure& measure = *measured_->measure;
    const double beside = measure.digits > 0 ? 0.0 : measure.lessIsBetter() ? 0.5 : -0.5;
    const double x = xOf(limit.at + beside);
    painter.setPen(QPen(palette().color(QPalette::Text), limit.gate.empty() ? 1.0 : 1.6,
                        limit.gate.empty() ? Qt::DotLine : Qt::DashLine));
    painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom()));
    const QString name =
        QString::number(limit.at, 'g', 4) +
        (limit.gate.empty() ? QString() : ' ' + QString::fromStdString(limit.gate));
    const double wide = metrics.horizontalAdvance(name);
    const double left = std::clamp(x - wide / 2.0, area.left(), width() - wide - 2.0);
    if (left < free) continue;
    free = left + wide + 6;
    painter.drawText(QPointF(left, area.top() - 4), name);
  }
}

void HistogramWidget::paintBars(QPainter& painter, const QRectF& area, MeshKind kind,
                                double top) const {
  const std::vector<double>& values = shares(kind);
  if (values.empty()) return;
  QPainterPath path(area.bottomLeft());
  for (int bar = 0; bar < measured_->bars; ++bar) {
    const QRectF room = barArea(bar);
    const double high = values[static_cast<std::size_t>(bar)] / top * area.height();
    const double y = area.bottom() - high;
    path.lineTo(room.left(), y);
    path.lineTo(room.right(), y);
    if (kind == selected_ && lit_ && bar >= lit_->first && bar <= lit_->second) {
      painter.fillRect(room, faded(kLitColour, 60));
      painter.fillRect(QRectF(room.left(), y, room.width(), high), kLitColour);
    }
  }
  path.lineTo(area.bottomRight());
  if (kind == selected_) painter.fillPath(path, faded(palette().color(QPalette::Highlight), 110));
  painter.setPen(outlinePen(kind, palette()));
  painter.drawPath(path);
}

void HistogramWidget::paintLegend(QPainter& painter, const QRectF& area) const {
  const QFontMetrics metrics = painter.fontMetrics();
  // On the side of the worst values, where there is room.
  const bool right = measured_->measure->lessIsBetter();
  double wide = 0.0;
  for (int i = 0; i < kMeshKindCount; ++i)
    wide = std::max(wide, 1.0 * metrics.horizontalAdvance(meshTitle(static_cast<MeshKind>(i))));
  const double left = right ? area.right() - wide - 34 : area.left() + 8;
  double y = area.top() + 2;
  for (int i = 0; i < kMeshKindCount; ++i) {
    const auto kind = static_cast<MeshKind>(i);
    if (shares(kind).empty()) continue;
    const QRectF text(left + 26, y, wide + 4, metrics.height());
    painter.setPen(outlinePen(kind, palette()));
    painter.drawLine(QPointF(left, text.center().y()), QPointF(left + 20, text.center().y()));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, meshTitle(kind));
    y += metrics.height();
  }
}

}  // namespace angiomesh

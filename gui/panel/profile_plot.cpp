// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/profile_plot.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "render/slice/slice_overlay.h"

namespace angiomesh {

namespace {

constexpr int kMargin = 6;
/// Of the usual step between points: beyond it nothing was measured.
constexpr double kGap = 2.5;

QColor faint(const QPalette& palette) {
  QColor colour = palette.color(QPalette::Text);
  colour.setAlpha(60);
  return colour;
}

}  // namespace

ProfilePlot::ProfilePlot(QWidget* parent) : QWidget(parent) {
  setMinimumSize(200, 110);
  setToolTip(
      tr("Diameter along the centre line: of the circle as large as the section and, thin, "
         "the least one. A click goes there."));
}

void ProfilePlot::setMeasurement(const Measurement* measurement) {
  profile_ = measurement ? measurement->profile : std::vector<ProfilePoint>();
  narrowest_ = nullptr;
  setVisible(profile_.size() > 1);
  if (profile_.size() < 2) return;
  fromMm_ = profile_.front().alongMm;
  toMm_ = std::max(profile_.back().alongMm, fromMm_ + 1e-3);
  mostMm_ = 0.0;
  std::vector<double> steps;
  for (std::size_t i = 0; i < profile_.size(); ++i) {
    mostMm_ = std::max(mostMm_, profile_[i].diameterMm);
    if (i > 0) steps.push_back(profile_[i].alongMm - profile_[i - 1].alongMm);
  }
  mostMm_ *= 1.1;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  usualStepMm_ = *middle;
  if (measurement->kind == MeasurementKind::Stenosis)
    narrowest_ = &*std::min_element(profile_.begin(), profile_.end(),
                                    [](const ProfilePoint& a, const ProfilePoint& b) {
                                      return a.minDiameterMm < b.minDiameterMm;
                                    });
  update();
}

QRectF ProfilePlot::area() const {
  const QFontMetrics metrics = fontMetrics();
  const int left = kMargin + metrics.horizontalAdvance(QStringLiteral("00.0")) + 4;
  const int line = metrics.height();
  return {static_cast<double>(left), kMargin + line + 2.0,
          static_cast<double>(width() - left - 2 * kMargin),
          height() - 2.0 * line - 2 * kMargin - 6};
}

QPointF ProfilePlot::place(double alongMm, double diameterMm) const {
  const QRectF frame = area();
  return {frame.left() + (alongMm - fromMm_) / (toMm_ - fromMm_) * frame.width(),
          frame.bottom() - diameterMm / mostMm_ * frame.height()};
}

QPointF ProfilePlot::positionOf(const ProfilePoint& point) const {
  return place(point.alongMm, point.diameterMm);
}

void ProfilePlot::paintAxes(QPainter& painter) const {
  const QRectF frame = area();
  const int line = fontMetrics().height();
  const QLocale locale;
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(kMargin, kMargin + fontMetrics().ascent(), tr("Diameter, mm"));
  const double up = scaleBarLengthMm(mostMm_ / 3.0);
  for (double value = 0.0; value < mostMm_; value += up) {
    const QPointF at = place(fromMm_, value);
    painter.setPen(faint(palette()));
    painter.drawLine(at, QPointF(frame.right(), at.y()));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(0, at.y() - line / 2.0, frame.left() - 4, line),
                     Qt::AlignRight | Qt::AlignVCenter, locale.toString(value, 'g', 3));
  }
  const QRectF below(frame.left(), frame.bottom() + 2, frame.width(), line);
  painter.drawText(below, Qt::AlignLeft, locale.toString(fromMm_, 'f', 1));
  painter.drawText(below, Qt::AlignHCenter, tr("along the centre line, mm"));
  painter.drawText(below, Qt::AlignRight, locale.toString(toMm_, 'f', 1));
}

void ProfilePlot::paintLine(QPainter& painter, double ProfilePoint::*value) const {
  QPainterPath path;
  for (std::size_t i = 0; i < profile_.size(); ++i) {
    const QPointF at = place(profile_[i].alongMm, profile_[i].*value);
    if (i == 0 || profile_[i].alongMm - profile_[i - 1].alongMm > kGap * usualStepMm_)
      path.moveTo(at);
    else
      path.lineTo(at);
  }
  painter.drawPath(path);
}

void ProfilePlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (profile_.size() < 2 || area().height() < 10) return;
  paintAxes(painter);
  if (narrowest_) {
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0, Qt::DashLine));
    painter.drawLine(place(narrowest_->alongMm, 0.0), place(narrowest_->alongMm, mostMm_));
  }
  painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
  paintLine(painter, &ProfilePoint::minDiameterMm);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  paintLine(painter, &ProfilePoint::diameterMm);
}

void ProfilePlot::mousePressEvent(QMouseEvent* event) {
  if (profile_.empty() || event->button() != Qt::LeftButton) return;
  const double x = event->position().x();
  const auto nearest = std::min_element(
      profile_.begin(), profile_.end(), [&](const ProfilePoint& a, const ProfilePoint& b) {
        return std::fabs(positionOf(a).x() - x) < std::fabs(positionOf(b).x() - x);
      });
  const Eigen::Vector3d& p = nearest->pointLps;
  Q_EMIT placePicked(p[0], p[1], p[2]);
}

}  // namespace angiomesh

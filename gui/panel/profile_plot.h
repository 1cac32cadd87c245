// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "core/measure/measurement.h"

namespace angiomesh {

/// The diameter of a vessel along its centre line, mm over mm: of the circle of the section's area,
/// and thinner the least one. Places where nothing was measured are gaps. A click names the place
/// nearest to it.
class ProfilePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ProfilePlot(QWidget* parent = nullptr);

  /// Of a measurement without a profile nothing is shown.
  void setMeasurement(const Measurement* measurement);
  /// Where a point of the profile is drawn.
  [[nodiscard]] QPointF positionOf(const ProfilePoint& point) const;

  [[nodiscard]] QSize sizeHint() const override { return {320, 150}; }

 Q_SIGNALS:
  void placePicked(double x, double y, double z);  ///< mm LPS

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] QPointF place(double alongMm, double diameterMm) const;
  void paintAxes(QPainter& painter) const;
  void paintLine(QPainter& painter, double ProfilePoint::*value) const;

  std::vector<ProfilePoint> profile_;
  double fromMm_ = 0.0, toMm_ = 1.0, mostMm_ = 1.0;  ///< of the axes
  double usualStepMm_ = 1.0;                         ///< between points
  const ProfilePoint* narrowest_ = nullptr;          ///< in profile_, of a stenosis
};

}  // namespace angiomesh

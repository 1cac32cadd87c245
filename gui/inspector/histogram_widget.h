// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QRectF>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gui/job/inspect_job.h"

class QPainter;

namespace angiomesh {

/// Histograms of one measure over the triangles of the meshes, each in percent of its own, with the
/// limits of gates as lines. The mesh selected is filled, the others are outlines. A click on a bar
/// or a drag over some picks them; a click on what is picked already picks nothing.
class HistogramWidget : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramWidget(QWidget* parent = nullptr);

  void setMeasured(std::shared_ptr<const MeasuredMeshes> measured);
  void setSelected(MeshKind kind);
  void setLit(const std::optional<std::pair<int, int>>& bars);
  /// Percent of the bars; empty where there is no mesh.
  [[nodiscard]] const std::vector<double>& shares(MeshKind kind) const;
  /// Where a bar stands, in pixels of the widget.
  [[nodiscard]] QRectF barArea(int bar) const;

  [[nodiscard]] QSize sizeHint() const override { return {320, 210}; }

 Q_SIGNALS:
  void barsPicked(const std::optional<std::pair<int, int>>& bars);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QRectF plotArea() const;
  [[nodiscard]] double xOf(double value) const;
  /// The bar under a place, if any.
  [[nodiscard]] std::optional<int> barAt(const QPointF& place) const;
  [[nodiscard]] double highest() const;
  void showTip(const QPoint& global, int bar);
  void paintScales(QPainter& painter, const QRectF& area, double top) const;
  void paintLimits(QPainter& painter, const QRectF& area) const;
  void paintBars(QPainter& painter, const QRectF& area, MeshKind kind, double top) const;
  void paintLegend(QPainter& painter, const QRectF& area) const;

  std::shared_ptr<const MeasuredMeshes> measured_;
  MeshKind selected_ = MeshKind::Exported;
  std::optional<std::pair<int, int>> lit_;
  std::optional<int> pressed_;
};

}  // namespace angiomesh

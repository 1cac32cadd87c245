// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QRectF>
#include <QString>
#include <QWidget>
#include <array>
#include <utility>
#include <vector>

#include "gui/job/run_job.h"

class QPainter;

namespace angiomesh {

/// Histograms of one quantity over the triangles of the three meshes, each as shares of its own
/// triangles. The mesh selected is filled, the others are outlines.
class HistogramWidget : public QWidget {
  Q_OBJECT

 public:
  HistogramWidget(QString title, double from, double to, int bins, QWidget* parent = nullptr);

  void setValues(MeshKind kind, const std::vector<float>& values);
  void setSelected(MeshKind kind);
  /// Shares of the bins, percent; empty where there are no values.
  [[nodiscard]] const std::vector<double>& shares(MeshKind kind) const;

  [[nodiscard]] QSize sizeHint() const override { return {320, 170}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBars(QPainter& painter, const QRectF& area, MeshKind kind, double top) const;
  void paintLegend(QPainter& painter, const QRectF& area) const;

  QString title_;
  double from_, to_;
  int bins_;
  MeshKind selected_ = MeshKind::Exported;
  std::array<std::vector<double>, kMeshKindCount> shares_;
};

}  // namespace angiomesh

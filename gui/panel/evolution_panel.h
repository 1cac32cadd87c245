// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QRectF>
#include <QWidget>

class QPainter;
class QPushButton;

namespace angiomesh {

struct CaseModels;

/// The evolution over its iterations, on a logarithmic scale: how far the front moved in each, its
/// change at the checks, and the tolerance. The marks below are fronts to go back to; a click or a
/// drag shows the nearest one, Left and Right the one before and the one after it.
class ConvergencePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ConvergencePlot(CaseModels& models, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override { return {360, 150}; }
  /// Where an iteration is drawn, pixels from the left.
  [[nodiscard]] double xOf(int iteration) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRectF plotArea() const;
  [[nodiscard]] int lastIteration() const;
  [[nodiscard]] QString title() const;
  void showNearest(double x);
  void showBeside(int step);
  void paintCurves(QPainter& painter, const QRectF& area) const;
  void paintFronts(QPainter& painter, const QRectF& area) const;

  CaseModels& models_;
};

/// The plot, and what can be done with an earlier front that it shows.
class EvolutionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EvolutionPanel(CaseModels& models, QWidget* parent = nullptr);

 private:
  void refresh();
  void useFront();

  CaseModels& models_;
  QPushButton* use_;
  QPushButton* back_;
};

}  // namespace angiomesh

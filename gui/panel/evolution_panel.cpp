// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/evolution_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/model/case_models.h"
#include "gui/panel/plot_frame.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr int kMargin = 6;
constexpr double kLeast = 1e-6;  // drawn, voxels

/// Decades from the first to the last one.
struct Decades {
  int from = 0, to = 1;

  [[nodiscard]] double share(double value) const {
    return (std::log10(std::max(value, kLeast)) - from) / (to - from);
  }
};

Decades decadesOf(const RunModel& runs, double tolerance) {
  double lowest = tolerance, highest = tolerance;
  const auto extend = [&](double value) {
    lowest = std::min(lowest, std::max(value, kLeast));
    highest = std::max(highest, value);
  };
  for (const auto& [iteration, change] : runs.history()) extend(change);
  for (const float motion : runs.motions()) extend(static_cast<double>(motion));
  Decades decades;
  decades.from = static_cast<int>(std::floor(std::log10(lowest)));
  decades.to = std::max(decades.from + 1, static_cast<int>(std::ceil(std::log10(highest))));
  return decades;
}

}  // namespace

ConvergencePlot::ConvergencePlot(CaseModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setMinimumSize(140, 90);
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(
      tr("Line: how far the front moves in an iteration, voxels; dots: its change at the checks; "
         "dashed: the tolerance. Click a mark below to see the front as it was then."));
  connect(&models_.timer, &JobTimer::ticked, this, [this] { update(); });
  connect(&models_.results, &ResultModel::resultsChanged, this, [this] { update(); });
}

QRectF ConvergencePlot::plotArea() const {
  const QFontMetrics metrics = fontMetrics();
  const int line = metrics.height();
  const int left = kMargin + metrics.horizontalAdvance("0.0001");
  return {left + 6.0, kMargin + line + 4.0, width() - left - 6.0 - 2 * kMargin,
          height() - 2.0 * line - 2 * kMargin - 8};
}

int ConvergencePlot::lastIteration() const {
  const RunModel& runs = models_.runs;
  int last = std::max(1, static_cast<int>(runs.motions().size()));
  if (!runs.history().empty()) last = std::max(last, runs.history().back().first);
  return last;
}

double ConvergencePlot::xOf(int iteration) const {
  const QRectF area = plotArea();
  return area.left() + 1.0 * iteration / lastIteration() * area.width();
}

QString ConvergencePlot::title() const {
  const RunModel& runs = models_.runs;
  if (runs.motions().empty() && runs.history().empty()) return tr("Change over iterations");
  QString text = tr("Iteration %1").arg(runs.iterations());
  if (!runs.motions().empty())
    text += tr(", moves %1 voxel").arg(static_cast<double>(runs.motions().back()), 0, 'g', 2);
  if (!runs.history().empty())
    text += tr(", change %1").arg(runs.history().back().second, 0, 'g', 3);
  return text;
}

void ConvergencePlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.setPen(palette().color(QPalette::Text));
  const QFontMetrics metrics = painter.fontMetrics();
  const QString text = metrics.elidedText(title(), Qt::ElideRight, width() - 2 * kMargin);
  painter.drawText(kMargin, kMargin + metrics.ascent(), text);
  const QRectF area = plotArea();
  drawPlotFrame(painter, area, palette());
  if ((models_.runs.history().empty() && models_.runs.motions().empty()) || area.height() < 10) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(area, Qt::AlignCenter, tr("No evolution yet"));
    return;
  }
  const int line = metrics.height();
  painter.setPen(palette().color(QPalette::Text));
  const QRectF below(area.left(), area.bottom() + 2, area.width(), line);
  painter.drawText(below, Qt::AlignRight, QString::number(lastIteration()));
  painter.drawText(below, Qt::AlignLeft, "0");
  paintCurves(painter, area);
  paintFronts(painter, area);
}

void ConvergencePlot::paintCurves(QPainter& painter, const QRectF& area) const {
  const RunModel& runs = models_.runs;
  const double tolerance = std::max(models_.document.parameters().levelset.tolerance, kLeast);
  const Decades decades = decadesOf(runs, tolerance);
  const auto place = [&](int iteration, double value) {
    return QPointF(xOf(iteration), area.bottom() - decades.share(value) * area.height());
  };
  const int line = painter.fontMetrics().height();
  for (int decade = decades.from; decade <= decades.to; ++decade) {
    const double value = std::pow(10.0, decade);
    const double y = place(0, value).y();
    painter.setPen(faintColour(palette()));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(0, y - line / 2.0, area.left() - 6.0, line),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(value));
  }
  painter.setPen(QPen(palette().color(QPalette::Text), 1.0, Qt::DashLine));
  painter.drawLine(place(0, tolerance), place(lastIteration(), tolerance));
  QPainterPath path;
  for (std::size_t i = 0; i < runs.motions().size(); ++i) {
    const QPointF at = place(static_cast<int>(i) + 1, static_cast<double>(runs.motions()[i]));
    if (i == 0)
      path.moveTo(at);
    else
      path.lineTo(at);
  }
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.6));
  painter.drawPath(path);
  painter.setBrush(palette().color(QPalette::Text));
  painter.setPen(Qt::NoPen);
  for (const auto& [iteration, change] : runs.history())
    painter.drawEllipse(place(iteration, change), 2.5, 2.5);
}

void ConvergencePlot::paintFronts(QPainter& painter, const QRectF& area) const {
  painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
  for (const auto& front : models_.runs.keptFronts()) {
    const double x = xOf(front->iterations);
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 5));
  }
  if (const auto& wanted = models_.results.wantedFront()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.6));
    const double x = xOf(wanted->iterations);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + 5));
  }
}

void ConvergencePlot::showNearest(double x) {
  const auto& fronts = models_.runs.keptFronts();
  const auto nearest =
      std::min_element(fronts.begin(), fronts.end(), [&](const auto& a, const auto& b) {
        return std::fabs(xOf(a->iterations) - x) < std::fabs(xOf(b->iterations) - x);
      });
  if (nearest != fronts.end()) models_.results.showFront(*nearest);
}

void ConvergencePlot::showBeside(int step) {
  const auto& fronts = models_.runs.keptFronts();
  const auto shown = std::find(fronts.begin(), fronts.end(), models_.results.wantedFront());
  const auto count = static_cast<int>(fronts.size());
  // With none shown the first step is back from where the evolution is.
  const int next = static_cast<int>(shown - fronts.begin()) + step;
  if (next >= count)
    models_.results.showFront(nullptr);
  else if (next >= 0)
    models_.results.showFront(fronts[static_cast<std::size_t>(next)]);
}

void ConvergencePlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) showNearest(event->position().x());
}

void ConvergencePlot::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) showNearest(event->position().x());
}

void ConvergencePlot::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left)
    showBeside(-1);
  else if (event->key() == Qt::Key_Right)
    showBeside(1);
  else
    QWidget::keyPressEvent(event);
}

EvolutionPanel::EvolutionPanel(CaseModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 6, 0);
  row->addWidget(named(new ConvergencePlot(models, this), "convergencePlot"), 1);
  auto* column = new QVBoxLayout;
  use_ = named(new QPushButton(tr("Use this front"), this), "useFront");
  use_->setToolTip(tr("Ends the evolution at this iteration (levelset.stopAfter)"));
  back_ = named(new QPushButton(tr("Back"), this), "leaveFront");
  column->addStretch(1);
  column->addWidget(use_);
  column->addWidget(back_);
  row->addLayout(column);
  back_->setToolTip(tr("Shows the last front, or the result, again"));
  connect(use_, &QPushButton::clicked, this, &EvolutionPanel::useFront);
  connect(back_, &QPushButton::clicked, this, [this] { models_.results.showFront(nullptr); });
  connect(&models_.results, &ResultModel::resultsChanged, this, &EvolutionPanel::refresh);
  refresh();
}

void EvolutionPanel::refresh() {
  const bool shown = models_.results.frontShown().has_value();
  use_->setEnabled(shown);
  back_->setEnabled(shown);
}

void EvolutionPanel::useFront() {
  const std::optional<int> iterations = models_.results.frontShown();
  if (!iterations) return;
  Parameters after = models_.document.parameters();
  after.levelset.stopAfter = *iterations;
  // A run that is on begins again by itself.
  const bool running = models_.runs.running();
  models_.document.change(after, tr("stop after iteration %1").arg(*iterations));
  if (!running) models_.runs.run(Step::Evolve);
}

}  // namespace angiomesh

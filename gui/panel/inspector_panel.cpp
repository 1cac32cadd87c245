// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/inspector_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

#include "gui/model/step_text.h"
#include "gui/model/view_state.h"
#include "gui/panel/plot_widget.h"
#include "gui/panel/surface_note.h"

namespace angiomesh {

namespace {

struct Row {
  const char* title;
  std::function<QString(const MeshQuality&)> text;
};

const QString kNothing = QStringLiteral("–");

QString count(std::size_t n) { return QLocale().toString(static_cast<qulonglong>(n)); }
QString fixed(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }
QString yesNo(bool value) { return value ? QStringLiteral("yes") : QStringLiteral("no"); }
QString deviation(const std::optional<DeviationStats>& stats, double DeviationStats::*member) {
  return stats ? QLocale().toString((*stats).*member, 'g', 3) : kNothing;
}
QString curved(const std::optional<CurvedDeviation>& stats, double CurvedDeviation::*member) {
  return stats ? QLocale().toString((*stats).*member, 'g', 3) : kNothing;
}

/// Not of the mesh alone: see refreshVerified().
constexpr const char* kVerifiedTitle = "Verified parts";

const std::vector<Row>& rows() {
  using Q = MeshQuality;
  // First what decides between meshes, then the rest.
  static const std::vector<Row> table{
      {"Triangles", [](const Q& q) { return count(q.triangles); }},
      {"From the front, %",
       [](const Q& q) { return q.fromFrontPercent ? fixed(*q.fromFrontPercent, 1) : kNothing; }},
      {kVerifiedTitle, [](const Q&) { return kNothing; }},
      {"Components", [](const Q& q) { return QString::number(q.components); }},
      {"Genus", [](const Q& q) { return QString::number(q.genus); }},
      {"Closed", [](const Q& q) { return yesNo(q.closed); }},
      {"Self-intersections", [](const Q& q) { return count(q.selfIntersections); }},
      {"Roughness, mm",
       [](const Q& q) {
         return q.roughness ? QLocale().toString(q.roughness->spreadMm, 'g', 3) : kNothing;
       }},
      {"Between neighbours, °",
       [](const Q& q) { return q.roughness ? fixed(q.roughness->angleDeg, 2) : kNothing; }},
      {"Min angle, least, °", [](const Q& q) { return fixed(q.minAngleMin, 2); }},
      {"Max angle, most, °", [](const Q& q) { return fixed(q.maxAngleMax, 2); }},
      {"Min angle < 30°, %", [](const Q& q) { return fixed(q.below30Percent, 2); }},
      {"Radius ratio, mean", [](const Q& q) { return fixed(q.radiusRatioMean, 3); }},
      {"Radius ratio, min", [](const Q& q) { return fixed(q.radiusRatioMin, 3); }},
      {"Vertex off, max, mm",
       [](const Q& q) { return deviation(q.vertexDeviation, &DeviationStats::maxMm); }},
      {"Centroid off, mean, mm",
       [](const Q& q) { return deviation(q.centroidDeviation, &DeviationStats::meanMm); }},
      {"Centroid off · κ, mean",
       [](const Q& q) { return curved(q.centroidTimesCurvature, &CurvedDeviation::mean); }},
      {"Area, mm²", [](const Q& q) { return fixed(q.areaMm2, 1); }},
      {"Volume, mm³", [](const Q& q) { return q.hasVolume() ? fixed(q.volumeMm3, 1) : kNothing; }},
      {"Vertices", [](const Q& q) { return count(q.vertices); }},
      {"Oriented", [](const Q& q) { return yesNo(q.oriented); }},
      {"Boundary edges", [](const Q& q) { return count(q.boundaryEdges); }},
      {"Boundary loops", [](const Q& q) { return count(q.boundaryLoops); }},
      {"Non-manifold edges", [](const Q& q) { return count(q.nonManifoldEdges); }},
      {"Non-manifold verts", [](const Q& q) { return count(q.nonManifoldVertices); }},
      {"Degenerate triangles", [](const Q& q) { return count(q.degenerateTriangles); }},
      {"Euler number", [](const Q& q) { return QString::number(q.euler); }},
      {"Min angle, 1 %, °", [](const Q& q) { return fixed(q.minAngleP01, 2); }},
      {"Min angle, mean, °", [](const Q& q) { return fixed(q.minAngleMean, 2); }},
      {"Max angle, 99 %, °", [](const Q& q) { return fixed(q.maxAngleP99, 2); }},
      {"Min angle < 20°, %", [](const Q& q) { return fixed(q.below20Percent, 2); }},
      {"Radius ratio, 1 %", [](const Q& q) { return fixed(q.radiusRatioP01, 3); }},
      {"Edge, min, mm", [](const Q& q) { return fixed(q.edgeMinMm, 3); }},
      {"Edge, mean, mm", [](const Q& q) { return fixed(q.edgeMeanMm, 3); }},
      {"Edge, max, mm", [](const Q& q) { return fixed(q.edgeMaxMm, 3); }},
      {"Vertex off, mean, mm",
       [](const Q& q) { return deviation(q.vertexDeviation, &DeviationStats::meanMm); }},
      {"Vertex off, 99 %, mm",
       [](const Q& q) { return deviation(q.vertexDeviation, &DeviationStats::p99Mm); }},
      {"Centroid off, 99 %, mm",
       [](const Q& q) { return deviation(q.centroidDeviation, &DeviationStats::p99Mm); }},
      {"Centroid off, max, mm",
       [](const Q& q) { return deviation(q.centroidDeviation, &DeviationStats::maxMm); }},
      {"Centroid off · κ, 99 %",
       [](const Q& q) { return curved(q.centroidTimesCurvature, &CurvedDeviation::p99); }},
      {"Roughness, 95 %, mm", [](const Q& q) {
         return q.roughness ? QLocale().toString(q.roughness->spread95Mm, 'g', 3) : kNothing;
       }}};
  return table;
}

}  // namespace

InspectorPanel::InspectorPanel(CaseModels& models, ViewState& state, QWidget* parent)
    : QWidget(parent), models_(models), state_(state) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  auto* form = new QFormLayout;
  mesh_ = new QComboBox(this);
  mesh_->setObjectName("meshShown");
  for (int kind = 0; kind < kMeshKindCount; ++kind) {
    mesh_->addItem(meshTitle(static_cast<MeshKind>(kind)));
  }
  form->addRow(tr("Mesh shown"), mesh_);
  colour_ = new QComboBox(this);
  colour_->setObjectName("meshColour");
  colour_->addItems({tr("plain"), tr("smallest angle"), tr("radius ratio")});
  form->addRow(tr("Colour"), colour_);
  comparison_ = new QCheckBox(tr("Marching cubes beside it"), this);
  comparison_->setObjectName("comparison");
  form->addRow(comparison_);
  column->addLayout(form);
  hints_ = new QLabel(this);
  hints_->setObjectName("hints");
  hints_->setWordWrap(true);
  column->addWidget(hints_);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  table_ = new QTableWidget(static_cast<int>(rows().size()), kMeshKindCount, splitter);
  table_->setObjectName("quality");
  buildTable();
  auto* plots = new QWidget(splitter);
  auto* plotColumn = new QVBoxLayout(plots);
  plotColumn->setContentsMargins(0, 0, 0, 0);
  angles_ = new HistogramWidget(tr("Smallest angle, ° (% of triangles)"), 0.0, 60.0, 60, plots);
  angles_->setObjectName("angleHistogram");
  ratios_ = new HistogramWidget(tr("Radius ratio (% of triangles)"), 0.0, 1.0, 50, plots);
  ratios_->setObjectName("ratioHistogram");
  plotColumn->addWidget(angles_);
  plotColumn->addWidget(ratios_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setChildrenCollapsible(false);
  column->addWidget(splitter, 1);
  setMinimumWidth(360);

  connect(mesh_, &QComboBox::activated, this,
          [this](int kind) { state_.setMeshKind(static_cast<MeshKind>(kind)); });
  connect(colour_, &QComboBox::activated, this,
          [this](int colour) { state_.setMeshColour(static_cast<MeshColour>(colour)); });
  connect(comparison_, &QCheckBox::toggled, &state_, &ViewState::setComparison);
  connect(&models_.results, &ResultModel::resultsChanged, this, &InspectorPanel::refreshResults);
  connect(&models_.runs, &RunModel::statesChanged, this, &InspectorPanel::refreshHints);
  connect(&state_, &ViewState::changed, this, &InspectorPanel::refreshState);
  refreshResults();
  refreshState();
}

void InspectorPanel::buildTable() {
  QStringList kinds, titles;
  for (int kind = 0; kind < kMeshKindCount; ++kind) {
    kinds << meshTitle(static_cast<MeshKind>(kind))
                 .replace(' ', '\n')
                 .replace("unsmoothed", "un-\nsmoothed")
                 .remove('(')
                 .remove(')');
  }
  for (const Row& row : rows()) {
    titles << QString::fromUtf8(row.title);
  }
  table_->setHorizontalHeaderLabels(kinds);
  table_->setVerticalHeaderLabels(titles);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  QFont small = table_->font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  table_->setFont(small);
  table_->horizontalHeader()->setFont(small);
  table_->verticalHeader()->setFont(small);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->horizontalHeader()->setMinimumSectionSize(
      QFontMetrics(small).horizontalAdvance(QStringLiteral("smoothed")) + 8);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setAlternatingRowColors(true);
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int kind = 0; kind < kMeshKindCount; ++kind) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, kind, item);
    }
  }
}

void InspectorPanel::refreshResults() {
  const std::shared_ptr<const MeshFacts> facts = models_.results.facts();
  for (int column = 0; column < kMeshKindCount; ++column) {
    const auto kind = static_cast<MeshKind>(column);
    const MeshQuality* quality = models_.results.quality(kind);
    for (int row = 0; row < table_->rowCount(); ++row) {
      table_->item(row, column)
          ->setText(quality ? rows()[static_cast<std::size_t>(row)].text(*quality) : kNothing);
    }
    const auto i = static_cast<std::size_t>(column);
    angles_->setValues(kind, facts ? facts->minAnglesDeg[i] : std::vector<float>());
    ratios_->setValues(kind, facts ? facts->radiusRatios[i] : std::vector<float>());
  }
  refreshVerified();
  refreshHints();
}

void InspectorPanel::refreshVerified() {
  const auto title = [](const Row& row) { return row.title == kVerifiedTitle; };
  const auto row =
      static_cast<int>(std::find_if(rows().begin(), rows().end(), title) - rows().begin());
  const SurfaceOrigin* origin = models_.results.surfaceOrigin();
  const QString text = origin ? verifiedText(*origin) : QString();
  const QString why = origin ? verifiedReasons(*origin) : QString();
  // Smoothing keeps what was verified: it neither cuts nor joins. Marching cubes is not checked.
  for (const MeshKind kind : {MeshKind::Exported, MeshKind::Unsmoothed}) {
    QTableWidgetItem* item = table_->item(row, static_cast<int>(kind));
    item->setText(text.isEmpty() ? kNothing : text);
    item->setToolTip(why);
  }
}

void InspectorPanel::refreshState() {
  const QSignalBlocker quietMesh(mesh_);
  const QSignalBlocker quietColour(colour_);
  mesh_->setCurrentIndex(static_cast<int>(state_.meshKind()));
  colour_->setCurrentIndex(static_cast<int>(state_.meshColour()));
  comparison_->setChecked(state_.comparison());
  angles_->setSelected(state_.meshKind());
  ratios_->setSelected(state_.meshKind());
  refreshHints();
}

void InspectorPanel::refreshHints() {
  const MeshQuality* q = models_.results.quality(state_.meshKind());
  if (!q) {
    hints_->setText(models_.results.mesh(state_.meshKind())
                        ? tr("Quality is not measured yet: run to the end.")
                        : tr("No mesh yet: open a volume and press Run."));
    return;
  }
  const auto mark = [](bool good) { return good ? QStringLiteral("✓ ") : QStringLiteral("✕ "); };
  const bool manifold = q->nonManifoldEdges == 0 && q->nonManifoldVertices == 0;
  QStringList lines;
  lines << mark(q->closed) +
               (q->closed ? tr("closed") : tr("open, rims: %1").arg(q->boundaryLoops));
  lines << mark(manifold) + (manifold ? tr("manifold") : tr("not manifold: a solver refuses it"));
  lines << mark(q->selfIntersections == 0) +
               (q->selfIntersections == 0 ? tr("no self-intersections")
                                          : tr("%1 self-intersections").arg(q->selfIntersections));
  lines << mark(q->degenerateTriangles == 0) +
               (q->degenerateTriangles == 0
                    ? tr("no degenerate triangles")
                    : tr("%1 degenerate triangles").arg(q->degenerateTriangles));
  const SurfaceOrigin* origin = models_.results.surfaceOrigin();
  if (origin && origin->unverified() > 0 && state_.meshKind() != MeshKind::MarchingCubes) {
    lines << mark(false) + tr("%1 parts not verified").arg(origin->unverified());
  }
  hints_->setToolTip(origin ? verifiedReasons(*origin) : QString());
  QString text = lines.join(QStringLiteral("   "));
  if (!models_.results.meshFresh()) {
    text = tr("◐ The mesh belongs to earlier parameters: run again.") + '\n' + text;
  }
  hints_->setText(text);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/inspector_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

#include "core/quality/quality_table.h"
#include "gui/model/result_text.h"
#include "gui/model/step_text.h"
#include "gui/model/view_state.h"
#include "gui/panel/dimmed.h"
#include "gui/panel/named.h"
#include "gui/panel/plot_widget.h"
#include "gui/panel/surface_note.h"

namespace angiomesh {

namespace {

constexpr int kLeastWidth = 360;
/// Room kept for the hints, so that the table below stays where it is.
constexpr int kHintLines = 3;

const QString kNothing = QStringLiteral("–");

/// Of the surface, not of a mesh's quality: see refreshVerified().
constexpr const char* kVerifiedTitle = "Verified parts";

/// What decides between meshes, then the rest; null stands for the verified parts.
const std::vector<const QualityMeasure*>& rows() {
  static const std::vector<const QualityMeasure*> table = [] {
    std::vector<const QualityMeasure*> all;
    for (const bool main : {true, false}) {
      for (const QualityMeasure& measure : qualityMeasures()) {
        if (measure.main == main) all.push_back(&measure);
        if (main && std::string(measure.key) == "components") all.push_back(nullptr);
      }
    }
    return all;
  }();
  return table;
}

QString titleOf(const QualityMeasure* measure) {
  if (!measure) return QCoreApplication::translate("QualityMeasure", kVerifiedTitle);
  const QString label = QCoreApplication::translate("QualityMeasure", measure->label);
  const QString unit = QString::fromLatin1(measure->unit)
                           .replace("deg", QStringLiteral("°"))
                           .replace("mm2", QStringLiteral("mm²"))
                           .replace("mm3", QStringLiteral("mm³"));
  return unit.isEmpty() ? label : label + ", " + unit;
}

QString valueOf(const QualityMeasure* measure, const MeshQuality* quality) {
  const std::optional<double> value =
      measure && quality ? measure->value(*quality) : std::optional<double>();
  if (!value) return kNothing;
  switch (measure->kind) {
    case MeasureKind::Count:
      return QLocale().toString(static_cast<qlonglong>(*value));
    case MeasureKind::YesNo:
      return *value != 0.0 ? QStringLiteral("yes") : QStringLiteral("no");
    case MeasureKind::Fixed:
      return QLocale().toString(*value, 'f', measure->digits);
    case MeasureKind::Significant:
      break;
  }
  return QLocale().toString(*value, 'g', measure->digits);
}

}  // namespace

InspectorPanel::InspectorPanel(CaseModels& models, ViewState& state, QWidget* parent)
    : QWidget(parent), models_(models), state_(state) {
  // A low window scrolls what does not fit.
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(scroll);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(4, 4, 4, 4);
  auto* form = new QFormLayout;
  mesh_ = named(new QComboBox(this), "meshShown");
  for (int kind = 0; kind < kMeshKindCount; ++kind)
    mesh_->addItem(meshTitle(static_cast<MeshKind>(kind)));
  form->addRow(tr("Mesh shown"), mesh_);
  colour_ = named(new QComboBox(this), "meshColour");
  colour_->addItems({tr("plain"), tr("smallest angle"), tr("radius ratio")});
  form->addRow(tr("Colour"), colour_);
  comparison_ = named(new QCheckBox(tr("Marching cubes beside it"), this), "comparison");
  form->addRow(comparison_);
  column->addLayout(form);
  hints_ = named(new QLabel(this), "hints");
  hints_->setWordWrap(true);
  hints_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  hints_->setMinimumHeight(kHintLines * hints_->fontMetrics().lineSpacing());
  column->addWidget(hints_);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  table_ =
      named(new QTableWidget(static_cast<int>(rows().size()), kMeshKindCount, splitter), "quality");
  buildTable();
  plots_ = new QWidget(splitter);
  auto* plotColumn = new QVBoxLayout(plots_);
  plotColumn->setContentsMargins(0, 0, 0, 0);
  angles_ =
      named(new HistogramWidget(tr("Smallest angle, ° (% of triangles)"), 0.0, 60.0, 60, plots_),
            "angleHistogram");
  ratios_ = named(new HistogramWidget(tr("Radius ratio (% of triangles)"), 0.0, 1.0, 50, plots_),
                  "ratioHistogram");
  plotColumn->addWidget(angles_);
  plotColumn->addWidget(ratios_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setChildrenCollapsible(false);
  column->addWidget(splitter, 1);
  scroll->setWidget(content);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  setMinimumWidth(std::max(kLeastWidth, content->minimumSizeHint().width() +
                                            scroll->verticalScrollBar()->sizeHint().width()));

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
  for (const QualityMeasure* measure : rows()) titles << titleOf(measure);
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
    for (int row = 0; row < table_->rowCount(); ++row)
      table_->item(row, column)->setText(valueOf(rows()[static_cast<std::size_t>(row)], quality));
    const auto i = static_cast<std::size_t>(column);
    angles_->setValues(kind, facts ? facts->minAnglesDeg[i] : std::vector<float>());
    ratios_->setValues(kind, facts ? facts->radiusRatios[i] : std::vector<float>());
  }
  refreshVerified();
  refreshHints();
}

void InspectorPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && hints_) refreshHints();  // the faint colour
}

void InspectorPanel::refreshVerified() {
  const auto row =
      static_cast<int>(std::find(rows().begin(), rows().end(), nullptr) - rows().begin());
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
  const ResultModel& results = models_.results;
  for (QWidget* measured : {static_cast<QWidget*>(table_), plots_})
    setDimmed(measured, meshText(results).stale);
  QString whose = tr("Result %1").arg(results.meshName());
  if (!results.meshFresh()) whose = tr("◐ %1 belongs to earlier parameters: run again.").arg(whose);
  const MeshQuality* q = results.quality(state_.meshKind());
  if (!q) {
    hints_->setText(results.mesh(state_.meshKind())
                        ? whose + '\n' + tr("Quality is not measured yet: run to the end.")
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
  if (origin && origin->unverified() > 0 && state_.meshKind() != MeshKind::MarchingCubes)
    lines << mark(false) + tr("%1 parts not verified").arg(origin->unverified());
  hints_->setToolTip(origin ? verifiedReasons(*origin) : QString());
  hints_->setText(whose + '\n' + lines.join(QStringLiteral("   ")));
}

}  // namespace angiomesh

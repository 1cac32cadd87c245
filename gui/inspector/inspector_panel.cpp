// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/inspector_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/findings/mesh_file.h"
#include "gui/findings/mesh_inspection.h"
#include "gui/inspector/gate_list.h"
#include "gui/inspector/histogram_widget.h"
#include "gui/inspector/quality_grid.h"
#include "gui/inspector/quality_text.h"
#include "gui/inspector/worst_list.h"
#include "gui/model/result_text.h"
#include "gui/model/step_text.h"
#include "gui/panel/dimmed.h"
#include "gui/panel/surface_note.h"
#include "gui/view/mesh_chooser.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr int kLeastWidth = 360;
/// Room kept for the hints, so that what is below stays where it is.
constexpr int kHintLines = 3;

}  // namespace

InspectorPanel::InspectorPanel(CaseModels& models, ViewState& state, MeshInspection& inspection,
                               const MeshFile& file, QWidget* parent)
    : QWidget(parent), models_(models), state_(state), inspection_(inspection), file_(file) {
  // A low window scrolls what does not fit.
  QScrollArea* scroll = columnScroll(this);
  auto* content = new QWidget(scroll);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(4, 4, 4, 4);
  addChoosers(column);
  tabs_ = named(new QTabWidget(this), "inspectorTabs");
  grid_ = new QualityGrid(models_, tabs_);
  tabs_->addTab(grid_, tr("Compare"));
  tabs_->addTab(gatesTab(), tr("Gates"));
  tabs_->addTab(trianglesTab(), tr("Triangles"));
  column->addWidget(tabs_, 1);
  scroll->setWidget(content);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  setMinimumWidth(std::max(kLeastWidth, content->minimumSizeHint().width() +
                                            scroll->verticalScrollBar()->sizeHint().width()));
  connect(&models_.results, &ResultModel::resultsChanged, this, &InspectorPanel::refreshHints);
  connect(&models_.runs, &RunModel::statesChanged, this, &InspectorPanel::refreshHints);
  connect(&state_, &ViewState::changed, this, &InspectorPanel::refreshState);
  connect(&file_, &MeshFile::changed, this, &InspectorPanel::refreshState);
  connectInspection();
  refreshMeasured();
  refreshState();
}

void InspectorPanel::addChoosers(QVBoxLayout* column) {
  auto* form = new QFormLayout;
  auto* mesh = named(new MeshCombo(MeshPlace::Shown, models_, state_, this), "meshShown");
  auto* row = new QHBoxLayout;
  row->addWidget(mesh, 1);
  auto* openMesh = named(new QToolButton(this), "openMeshButton");
  openMesh->setText(QStringLiteral("…"));
  openMesh->setAccessibleName(tr("Mesh from a file"));
  openMesh->setToolTip(tr("Compares a mesh from a file (PLY, STL, OBJ, OFF, VTP, VTK) with these"));
  row->addWidget(openMesh);
  connect(openMesh, &QToolButton::clicked, this, &InspectorPanel::openMeshRequested);
  form->addRow(tr("Mesh shown"), row);
  colour_ = named(new QComboBox(this), "meshColour");
  colour_->addItem(tr("plain"));
  for (const TriangleMeasure& measure : triangleMeasures()) {
    colour_->addItem(measureTitle(measure));
    colour_->setItemData(colour_->count() - 1,
                         QCoreApplication::translate("TriangleMeasure", measure.meaning),
                         Qt::ToolTipRole);
  }
  form->addRow(tr("Colour"), colour_);
  comparison_ = named(new QCheckBox(tr("Beside it"), this), "comparison");
  form->addRow(comparison_,
               named(new MeshCombo(MeshPlace::Beside, models_, state_, this), "meshBeside"));
  column->addLayout(form);
  hints_ = named(new QLabel(this), "hints");
  hints_->setWordWrap(true);
  hints_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  hints_->setMinimumHeight(kHintLines * hints_->fontMetrics().lineSpacing());
  column->addWidget(hints_);
  connect(colour_, &QComboBox::activated, this, [this](int colour) {
    state_.setMeshColour(colour > 0 ? &triangleMeasures()[static_cast<std::size_t>(colour) - 1]
                                    : nullptr);
  });
  connect(comparison_, &QCheckBox::toggled, &state_, &ViewState::setComparison);
}

QWidget* InspectorPanel::gatesTab() {
  QScrollArea* scroll = columnScroll(tabs_);
  scroll->setWidget(new GateList(models_, state_, scroll));
  return scroll;
}

QWidget* InspectorPanel::trianglesTab() {
  triangles_ = new QWidget(tabs_);
  auto* column = new QVBoxLayout(triangles_);
  column->setContentsMargins(4, 4, 4, 4);
  auto* splitter = new QSplitter(Qt::Vertical, triangles_);
  splitter->setChildrenCollapsible(false);
  auto* spread = new QWidget(splitter);
  auto* spreadColumn = new QVBoxLayout(spread);
  spreadColumn->setContentsMargins(0, 0, 0, 0);
  histogram_ = named(new HistogramWidget(spread), "histogram");
  histogram_->setToolTip(tr("A click on a bar lights its triangles up in 3D; drag for more bars"));
  spreadColumn->addWidget(histogram_, 1);
  bands_ = named(new QLabel(spread), "bands");
  bands_->setTextFormat(Qt::RichText);
  bands_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  spreadColumn->addWidget(bands_);
  auto* worst = new QWidget(splitter);
  auto* worstColumn = new QVBoxLayout(worst);
  worstColumn->setContentsMargins(0, 0, 0, 0);
  worstColumn->addWidget(new QLabel(tr("Worst of the mesh shown"), worst));
  worstColumn->addWidget(new WorstList(inspection_, models_, state_, worst), 1);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  column->addWidget(splitter);
  return triangles_;
}

void InspectorPanel::connectInspection() {
  connect(&inspection_, &MeshInspection::changed, this, &InspectorPanel::refreshMeasured);
  connect(&inspection_, &MeshInspection::litChanged, this,
          [this] { histogram_->setLit(inspection_.litBars()); });
  connect(histogram_, &HistogramWidget::barsPicked, &inspection_, &MeshInspection::lightBars);
}

void InspectorPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && hints_ && triangles_) refreshHints();  // faint
}

void InspectorPanel::refreshMeasured() {
  histogram_->setMeasured(inspection_.measured());
  bands_->setText(inspection_.measured() ? bandTable(*inspection_.measured()) : QString());
}

void InspectorPanel::refreshState() {
  const QSignalBlocker quietColour(colour_);
  const TriangleMeasure* colour = state_.meshColour();
  colour_->setCurrentIndex(colour ? 1 + static_cast<int>(colour - triangleMeasures().data()) : 0);
  comparison_->setChecked(state_.comparison());
  histogram_->setSelected(models_.results.kindAtHand(state_.meshKind()));
  refreshHints();
}

void InspectorPanel::refreshHints() {
  const ResultModel& results = models_.results;
  for (QWidget* measured : {static_cast<QWidget*>(grid_), triangles_})
    setDimmed(measured, meshText(results).stale);
  QString whose = tr("Result %1").arg(results.meshName());
  if (results.kindAtHand(state_.meshKind()) == MeshKind::File)
    whose = QStringList{file_.name(), file_.limits()}.join(QStringLiteral("  "));
  else if (!results.meshFresh())
    whose = tr("◐ %1 belongs to earlier parameters: run again.").arg(whose);
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
  if (origin && origin->unverified() > 0 && isOurs(state_.meshKind()))
    lines << mark(false) + tr("%1 parts not verified").arg(origin->unverified());
  hints_->setToolTip(origin ? verifiedReasons(*origin) : QString());
  hints_->setText(whose + '\n' + lines.join(QStringLiteral("   ")));
}

}  // namespace angiomesh

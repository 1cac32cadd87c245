// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/case_tables.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/formatted.h"
#include "gui/model/case_models.h"
#include "gui/model/result_text.h"
#include "gui/panel/dimmed.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// Noise can leave thousands of specks; the largest parts are those that anybody ticks.
constexpr int kMostRows = 300;
constexpr int kRowsInView = 6;
constexpr int kStepIterations = 10;

/// "2. Erase, L 12.3 A 4.5 S 67.8 mm (-35 voxels)"
QString correctionRow(const CaseCorrections& corrections, std::size_t index) {
  const Correction correction = parseCorrection(corrections.all()[index]);
  QString row = CorrectionList::tr("%1. %2, %3")
                    .arg(index + 1)
                    .arg(correctionTitle(correction.kind),
                         QString::fromStdString(placeText(correction.placesLps.front())));
  const CorrectionOutcome* outcome = corrections.outcome(index);
  if (outcome == nullptr) return row;
  if (!outcome->why.empty()) return CorrectionList::tr("%1 (left out)").arg(row);
  const auto change = static_cast<qint64>(outcome->added) - static_cast<qint64>(outcome->removed);
  return CorrectionList::tr("%1 (%2 voxels)")
      .arg(row, (change > 0 ? QStringLiteral("+") : QString()) + QString::number(change));
}

QVBoxLayout* tightColumn(QWidget* parent) {
  auto* column = new QVBoxLayout(parent);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  return column;
}

}  // namespace

SeedList::SeedList(CaseModels& models, QWidget* parent) : QWidget(parent), models_(models) {
  auto* column = tightColumn(this);
  summary_ = named(new QLabel(this), "seedSummary");
  column->addWidget(summary_);
  list_ = named(new QListWidget(this), "seedList");
  list_->setMaximumHeight(84);
  column->addWidget(list_);
  remove_ = named(new QPushButton(tr("Remove seed"), this), "removeSeed");
  column->addWidget(remove_, 0, Qt::AlignLeft);
  connect(remove_, &QPushButton::clicked, this,
          [this] { models_.document.removeSeed(list_->currentRow()); });
  connect(list_, &QListWidget::currentRowChanged, this,
          [this](int row) { remove_->setEnabled(row >= 0); });
  connect(&models_.document, &CaseDocument::parametersChanged, this, &SeedList::refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, &SeedList::refresh);
  refresh();
}

void SeedList::refresh() {
  const auto seeds = models_.document.seeds();
  const int row = list_->currentRow();
  list_->clear();
  for (const Eigen::Vector3d& seed : seeds) list_->addItem(QString::fromStdString(placeText(seed)));
  list_->setCurrentRow(std::min(row, list_->count() - 1));
  const bool any = !seeds.empty();
  list_->setVisible(any);
  remove_->setVisible(any);
  remove_->setEnabled(list_->currentRow() >= 0);
  const auto result = models_.results.seedsResult();
  summary_->setText(result ? tr("%1 seeds in use").arg(result->pointsLps.size())
                           : tr("No seeds yet"));
}

CorrectionList::CorrectionList(CaseModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  auto* column = tightColumn(this);
  auto* brush = new QHBoxLayout;
  radius_ = named(new QDoubleSpinBox(this), "brushRadius");
  radius_->setRange(CaseCorrections::kLeastRadiusMm, CaseCorrections::kGreatestRadiusMm);
  radius_->setDecimals(2);
  radius_->setSingleStep(0.25);
  radius_->setPrefix(tr("Brush: "));
  radius_->setSuffix(tr(" mm"));
  radius_->setKeyboardTracking(false);
  radius_->setToolTip(tr("Radius of the brush ([ and ])"));
  brush->addWidget(radius_);
  toEdge_ = named(new QCheckBox(tr("To the edge"), this), "toEdge");
  toEdge_->setToolTip(
      tr("The brush adds only what is as bright as a vessel, and erases only what is not"));
  brush->addWidget(toEdge_, 1);
  column->addLayout(brush);
  list_ = named(new QListWidget(this), "correctionList");
  list_->setMaximumHeight(108);
  list_->setTextElideMode(Qt::ElideRight);
  column->addWidget(list_);
  remove_ = named(new QPushButton(tr("Remove correction"), this), "removeCorrection");
  column->addWidget(remove_, 0, Qt::AlignLeft);
  CaseCorrections& corrections = models_.corrections;
  connect(radius_, &QDoubleSpinBox::valueChanged, &corrections, &CaseCorrections::setRadius);
  connect(toEdge_, &QCheckBox::toggled, &corrections, &CaseCorrections::setToEdge);
  connect(remove_, &QPushButton::clicked, this,
          [this] { models_.corrections.remove(static_cast<std::size_t>(list_->currentRow())); });
  connect(list_, &QListWidget::currentRowChanged, this,
          [this](int row) { remove_->setEnabled(row >= 0); });
  connect(&corrections, &CaseCorrections::changed, this, &CorrectionList::refresh);
  refresh();
}

void CorrectionList::refresh() {
  const CaseCorrections& corrections = models_.corrections;
  const QSignalBlocker quietRadius(radius_), quietEdge(toEdge_);
  if (std::fabs(radius_->value() - corrections.radiusMm()) > 0.005)
    radius_->setValue(corrections.radiusMm());
  toEdge_->setChecked(corrections.toEdge());
  QStringList rows;
  for (std::size_t n = 0; n < corrections.all().size(); ++n) rows << correctionRow(corrections, n);
  const int row = list_->currentRow();
  bool same = list_->count() == rows.size();
  for (int n = 0; same && n < rows.size(); ++n) same = list_->item(n)->text() == rows[n];
  if (!same) {
    list_->clear();
    list_->addItems(rows);
    list_->setCurrentRow(std::min(row, list_->count() - 1));
  }
  const bool any = !rows.isEmpty();
  list_->setVisible(any);
  remove_->setVisible(any);
  remove_->setEnabled(list_->currentRow() >= 0);
}

ComponentTable::ComponentTable(CaseModels& models, QWidget* parent)
    : QFrame(parent), models_(models) {
  setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 5, 8, 6);
  summary_ = named(new QLabel(this), "componentSummary");
  summary_->setWordWrap(true);
  column->addWidget(summary_);
  table_ = named(new QTableWidget(0, 5, this), "components");
  table_->setHorizontalHeaderLabels(
      {tr("Part"), tr("Voxels"), tr("mm³"), tr("Length"), tr("Radius")});
  table_->horizontalHeaderItem(3)->setToolTip(tr("Of the centre lines, all branches, mm"));
  table_->horizontalHeaderItem(4)->setToolTip(tr("Mean radius, mm"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  column->addWidget(table_);
  connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() == 0) {
      // Queued: the edit refills the table, which must not happen inside its own signal.
      const int row = item->row();
      const bool on = item->checkState() == Qt::Checked;
      QMetaObject::invokeMethod(
          this, [this, row, on] { models_.results.setComponentTicked(row, on); },
          Qt::QueuedConnection);
    }
  });
  connect(&models_.results, &ResultModel::resultsChanged, this, &ComponentTable::refresh);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &ComponentTable::refresh);
  refresh();
}

void ComponentTable::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && table_)
    setDimmed(table_, meshText(models_.results).stale);  // in the faint colour of now
}

void ComponentTable::refresh() {
  const std::vector<ComponentRow> rows = models_.results.components();
  const int count = std::min(static_cast<int>(rows.size()), kMostRows);
  const QSignalBlocker quiet(table_);
  table_->setRowCount(count);
  for (int i = 0; i < count; ++i) {
    const ComponentRow& row = rows[static_cast<std::size_t>(i)];
    auto* name = new QTableWidgetItem(QString::number(i + 1));
    name->setCheckState(row.ticked ? Qt::Checked : Qt::Unchecked);
    name->setFlags(row.byRule ? Qt::ItemIsSelectable
                              : Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    name->setToolTip(row.byRule ? tr("Left out by which parts are kept, or by the least volume")
                                : tr("Ticked off: not meshed"));
    table_->setItem(i, 0, name);
    QStringList numbers{QString::number(row.voxels), QString::number(row.volumeMm3, 'f', 1)};
    if (row.measure) {
      numbers << (row.measure->lengthMm > 0.0 ? QString::number(row.measure->lengthMm, 'f', 1)
                                              : QString())
              << QString::number(row.measure->meanRadiusMm, 'f', 2);
    }
    for (int c = 0; c + 1 < table_->columnCount(); ++c) {
      auto* cell = new QTableWidgetItem(numbers.value(c));
      cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(i, c + 1, cell);
    }
  }
  const int rowHeight = table_->verticalHeader()->defaultSectionSize();
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         std::min(count, kRowsInView) * rowHeight + 2 * table_->frameWidth());
  setVisible(count > 0);
  const ShownText whose = meshText(models_.results);
  const QString parts =
      static_cast<int>(rows.size()) > count
          ? tr("Parts: %1 (the largest %2 are listed)").arg(rows.size()).arg(count)
          : tr("Parts: %1").arg(count);
  summary_->setText(tr("%1. %2").arg(whose.text, parts));
  setDimmed(table_, whose.stale);
}

EvolutionControls::EvolutionControls(CaseModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  auto* column = tightColumn(this);
  text_ = named(new QLabel(this), "evolutionText");
  column->addWidget(text_);
  auto* row = new QHBoxLayout;
  pause_ = named(new QPushButton(tr("Pause"), this), "pause");
  step_ = named(new QPushButton(tr("Step"), this), "step");
  step_->setToolTip(tr("%1 iterations, then pause again").arg(kStepIterations));
  finish_ = named(new QPushButton(tr("Finish"), this), "finish");
  finish_->setToolTip(tr("Takes the surface as it stands"));
  for (QPushButton* button : {pause_, step_, finish_}) row->addWidget(button);
  column->addLayout(row);
  connect(pause_, &QPushButton::clicked, this,
          [this] { models_.runs.setPaused(!models_.runs.paused()); });
  connect(step_, &QPushButton::clicked, this,
          [this] { models_.runs.stepEvolution(kStepIterations); });
  connect(finish_, &QPushButton::clicked, this, [this] { models_.runs.finishEvolution(); });
  connect(&models_.runs, &RunModel::statesChanged, this, &EvolutionControls::refresh);
  connect(&models_.timer, &JobTimer::ticked, this, &EvolutionControls::showProgress);
  refresh();
}

void EvolutionControls::refresh() {
  const bool evolving = models_.runs.evolving();
  pause_->setEnabled(evolving);
  pause_->setText(models_.runs.paused() ? tr("Resume") : tr("Pause"));
  step_->setEnabled(evolving && models_.runs.paused());
  finish_->setEnabled(evolving);
  showProgress();
}

void EvolutionControls::showProgress() {
  if (pause_->isEnabled() != models_.runs.evolving()) {
    refresh();
    return;
  }
  const int iterations = models_.runs.iterations();
  const bool any = iterations > 0 || models_.runs.evolving();
  text_->setText(
      !any ? tr("No iterations yet")
      : models_.runs.change() < 0.0
          ? tr("Iteration %1").arg(iterations)
          : tr("Iteration %1, change %2").arg(iterations).arg(models_.runs.change(), 0, 'g', 3));
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/sensitivity_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/model/step_text.h"
#include "gui/panel/dimmed.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

enum StepColumn { StepTried, MeanMove, P95, Lost, MoreVolume };
enum BranchColumn { BranchNumber, Length, Radius, Change, BranchLost };

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

/// With its sign, unless it is shown as 0.
QString change(double value, int decimals) {
  const QString size = number(std::abs(value), decimals);
  if (size == number(0.0, decimals)) return size;
  return (value < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) + size;
}

QString percent(const QString& number) { return number + QStringLiteral(" %"); }

void put(QTableWidget& table, int row, int column, const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  table.setItem(row, column, item);
}

QTableWidget* makeTable(QWidget* parent, const char* name, const QStringList& titles,
                        const QStringList& tips) {
  auto* table = named(new QTableWidget(0, static_cast<int>(titles.size()), parent), name);
  table->setHorizontalHeaderLabels(titles);
  for (int column = 0; column < tips.size(); ++column)
    table->horizontalHeaderItem(column)->setToolTip(tips[column]);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  return table;
}

}  // namespace

SensitivityPanel::SensitivityPanel(CaseSensitivity& sensitivity, QWidget* parent)
    : QWidget(parent), sensitivity_(sensitivity) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  auto* row = new QHBoxLayout;
  start_ = named(new QPushButton(tr("Try the parameters"), this), "sensitivityStart");
  start_->setToolTip(
      tr("Runs the segmentation in the background with each main parameter a step up and a step "
         "down. The case stays as it is."));
  cancel_ = named(new QPushButton(tr("Cancel"), this), "sensitivityCancel");
  paint_ = named(new QCheckBox(tr("Paint the wall"), this), "sensitivityPaint");
  paint_->setToolTip(tr("Shows in 3D, in place of the mesh, the wall with its moves in colour"));
  row->addWidget(start_);
  row->addWidget(cancel_);
  row->addWidget(paint_);
  row->addStretch(1);
  column->addLayout(row);
  progress_ = named(new QProgressBar(this), "sensitivityProgress");
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(5);
  column->addWidget(progress_);
  note_ = named(new QLabel(this), "sensitivityNote");
  note_->setWordWrap(true);
  column->addWidget(note_);
  buildTables();
  column->addWidget(steps_, 3);
  column->addWidget(branches_, 2);
  connect(start_, &QPushButton::clicked, &sensitivity_, &CaseSensitivity::start);
  connect(cancel_, &QPushButton::clicked, &sensitivity_, &CaseSensitivity::cancel);
  connect(paint_, &QCheckBox::clicked, &sensitivity_, &CaseSensitivity::setPainted);
  connect(&sensitivity_, &CaseSensitivity::changed, this, &SensitivityPanel::refresh);
  connect(&sensitivity_, &CaseSensitivity::progressed, this, &SensitivityPanel::showProgress);
  refresh();
}

void SensitivityPanel::buildTables() {
  steps_ = makeTable(this, "sensitivitySteps",
                     {tr("Step"), tr("Mean, mm"), tr("95 %"), tr("Lost"), tr("Volume")},
                     {tr("The parameter, its value, and the value that was tried"),
                      tr("Mean move of the wall, outwards positive, without what is lost"),
                      tr("95 % of the wall move less than this either way, mm"),
                      tr("Part of the wall whose vessel is gone"),
                      tr("By how much the vessels have more volume")});
  branches_ = makeTable(
      this, "sensitivityBranches",
      {tr("No."), tr("Length, mm"), tr("Radius, mm"), tr("Change"), tr("Lost")},
      {tr("The longest first; a click takes the panes there"), tr("Of its centre line"),
       tr("Mean radius"),
       tr("By how much the mean radius is larger after the step, mm; with all steps the largest "
          "change"),
       tr("Part of its wall that is lost; with all steps the largest part")});
  connect(steps_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0) sensitivity_.choose(steps_->item(row, 0)->data(Qt::UserRole).toInt());
  });
  connect(branches_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (row >= 0) sensitivity_.visit(branches_->item(row, 0)->data(Qt::UserRole).toInt());
  });
}

void SensitivityPanel::refresh() {
  const bool busy = sensitivity_.busy();
  const QString whyNot = sensitivity_.whyNot();
  start_->setEnabled(!busy && whyNot.isEmpty());
  cancel_->setEnabled(busy);
  progress_->setVisible(busy);
  showProgress();
  const auto& found = sensitivity_.found();
  paint_->setEnabled(found != nullptr);
  paint_->setChecked(sensitivity_.painted());
  note_->setText(!whyNot.isEmpty()                 ? whyNot
                 : !sensitivity_.error().isEmpty() ? sensitivity_.error()
                 : busy                            ? tr("Trying…")
                 : !found ? tr("By how much does the wall move when a parameter does?")
                 : sensitivity_.stale()
                     ? tr("Of earlier parameters: try again for the present ones.")
                     : tr("%1 steps in %2")
                           .arg(found->found.effects.size())
                           .arg(durationText(sensitivity_.seconds())));
  if (found.get() != filled_) {
    fillSteps();
    fillBranches();
  } else if (sensitivity_.chosen() != filledBranches_) {
    fillBranches();
  }
  for (QTableWidget* table : {steps_, branches_}) setDimmed(table, sensitivity_.stale());
}

void SensitivityPanel::showProgress() {
  progress_->setValue(static_cast<int>(1000.0 * sensitivity_.fraction()));
}

void SensitivityPanel::fillSteps() {
  const QSignalBlocker quiet(steps_);
  filled_ = sensitivity_.found().get();
  steps_->setRowCount(0);
  if (!filled_) return;
  const std::vector<StepEffect>& effects = filled_->found.effects;
  steps_->setRowCount(static_cast<int>(effects.size()) + 1);
  put(*steps_, 0, StepTried, tr("All: largest move"));
  steps_->item(0, 0)->setData(Qt::UserRole, CaseSensitivity::kAll);
  // What matters most comes first.
  std::vector<std::size_t> order(effects.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return effects[a].moves.meanSizeMm > effects[b].moves.meanSizeMm;
  });
  for (std::size_t n = 0; n < order.size(); ++n) {
    const StepEffect& effect = effects[order[n]];
    const int row = static_cast<int>(n) + 1;
    put(*steps_, row, StepTried, CaseSensitivity::stepText(effect.step));
    steps_->item(row, 0)->setData(Qt::UserRole, static_cast<int>(order[n]));
    if (!effect.why.empty()) {
      steps_->item(row, 0)->setToolTip(QString::fromStdString(effect.why));
      steps_->item(row, 0)->setFlags(Qt::NoItemFlags);
      put(*steps_, row, MeanMove, tr("none"));
      continue;
    }
    const WallMoves& moves = effect.moves;
    put(*steps_, row, MeanMove, change(moves.meanMm, 3));
    put(*steps_, row, P95, number(moves.p95Mm, 3));
    put(*steps_, row, Lost, percent(number(moves.lostPercent, 1)));
    put(*steps_, row, MoreVolume, percent(change(moves.volumePercent, 1)));
  }
  steps_->setCurrentCell(0, 0);
}

void SensitivityPanel::fillBranches() {
  const QSignalBlocker quiet(branches_);
  filledBranches_ = sensitivity_.chosen();
  branches_->setRowCount(0);
  if (!filled_) return;
  const std::vector<SkeletonBranch>& all = filled_->found.places.skeleton.branches;
  std::vector<std::size_t> order(all.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all[a].lengthMm > all[b].lengthMm; });
  branches_->setRowCount(static_cast<int>(all.size()));
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::size_t branch = order[n];
    const int row = static_cast<int>(n);
    double moved = 0.0, lost = 0.0;
    const auto take = [&](const StepEffect& effect) {
      if (!effect.why.empty()) return;
      const WallMoves::Branch& one = effect.moves.branches[branch];
      if (std::abs(one.meanMm) > std::abs(moved)) moved = one.meanMm;
      lost = std::max(lost, one.lostPercent);
    };
    if (filledBranches_ == CaseSensitivity::kAll)
      std::for_each(filled_->found.effects.begin(), filled_->found.effects.end(), take);
    else
      take(filled_->found.effects[static_cast<std::size_t>(filledBranches_)]);
    put(*branches_, row, BranchNumber, QString::number(row + 1));
    branches_->item(row, 0)->setData(Qt::UserRole, static_cast<int>(branch));
    put(*branches_, row, Length, number(all[branch].lengthMm, 1));
    put(*branches_, row, Radius, number(all[branch].meanRadiusMm, 2));
    put(*branches_, row, Change, change(moved, 3));
    put(*branches_, row, BranchLost, percent(number(lost, 1)));
  }
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/inspector/worst_list.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include "core/base/formatted.h"
#include "gui/findings/mesh_inspection.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

constexpr int kLeastRows = 5;

}  // namespace

WorstList::WorstList(MeshInspection& inspection, CaseModels& models, ViewState& state,
                     QWidget* parent)
    : QTableWidget(0, 2, parent), inspection_(inspection), models_(models), state_(state) {
  setObjectName("worst");
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setAlternatingRowColors(true);
  horizontalHeader()->setStretchLastSection(true);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setMinimumHeight(horizontalHeader()->sizeHint().height() +
                   kLeastRows * verticalHeader()->defaultSectionSize());
  setToolTip(tr("Choose a row to go there in 3D and in the slices; the arrow keys go on."));
  const auto go = [this](int row) {
    if (row >= 0) inspection_.goToWorst(static_cast<std::size_t>(row));
  };
  connect(this, &QTableWidget::currentCellChanged, this, [go](int row, int, int before, int) {
    if (row != before) go(row);
  });
  // Back there, once one has looked elsewhere.
  connect(this, &QTableWidget::cellClicked, this, [go](int row, int) { go(row); });
  connect(&inspection_, &MeshInspection::changed, this, &WorstList::refresh);
  connect(&state_, &ViewState::changed, this, &WorstList::refresh);
  refresh();
}

void WorstList::refresh() {
  const auto& measured = inspection_.measured();
  const MeshKind kind = models_.results.kindAtHand(state_.meshKind());
  const auto* worst = measured ? &measured->of(kind).worst : nullptr;
  const auto textAt = [&](int row, int column) {
    const WorstPlace& place = (*worst)[static_cast<std::size_t>(row)];
    return column == 0 ? measureValue(*measured->measure, place.value)
                       : QString::fromStdString(placeText(place.centreLps));
  };
  const QSignalBlocker quiet(this);
  setHorizontalHeaderLabels(
      {measured ? measureTitle(*measured->measure) : tr("Value"), tr("Place")});
  const int rows = worst ? static_cast<int>(worst->size()) : 0;
  bool same = rows == rowCount();
  for (int row = 0; same && row < rows; ++row)
    for (int column = 0; same && column < 2; ++column)
      same = item(row, column) && item(row, column)->text() == textAt(row, column);
  if (same) return;
  clearContents();
  setRowCount(rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < 2; ++column) {
      auto* cell = new QTableWidgetItem(textAt(row, column));
      cell->setTextAlignment((column == 0 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      setItem(row, column, cell);
    }
  setCurrentCell(-1, -1);
  resizeColumnToContents(0);
}

}  // namespace angiomesh

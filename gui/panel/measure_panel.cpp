// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/measure_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>

#include "gui/findings/case_measures.h"
#include "gui/findings/measurement_text.h"
#include "gui/panel/action_buttons.h"
#include "gui/panel/named.h"
#include "gui/panel/profile_plot.h"

namespace angiomesh {

namespace {

enum Column { Name, Kind, Value, ColumnCount };
constexpr int kNameRole = Qt::UserRole;
constexpr int kNameWidth = 92;

}  // namespace

MeasurePanel::MeasurePanel(CaseMeasures& measures, QWidget* parent)
    : QWidget(parent), measures_(measures), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(4, 4, 4, 4);
  column_->setSpacing(3);
  buildTable();
  plot_ = named(new ProfilePlot(this), "profilePlot");
  column_->addWidget(plot_);
  details_ = named(new QLabel(this), "measureDetails");
  notice_ = named(new QLabel(this), "measureNotice");
  for (QLabel* label : {details_, notice_}) {
    label->setWordWrap(true);
    column_->addWidget(label);
  }
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(plot_, &ProfilePlot::placePicked, this, &MeasurePanel::placePicked);
  connect(&measures_, &CaseMeasures::changed, this, &MeasurePanel::refresh);
  refresh();
}

void MeasurePanel::buildTable() {
  table_ = named(new QTableWidget(0, ColumnCount, this), "measurements");
  table_->setHorizontalHeaderLabels({tr("Name"), tr("Kind"), tr("Value")});
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(Name, QHeaderView::Interactive);
  header->resizeSection(Name, kNameWidth);
  header->setSectionResizeMode(Value, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setWordWrap(true);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setTabKeyNavigation(false);
  column_->addWidget(table_, 1);
  connect(table_, &QTableWidget::itemChanged, this,
          [this](QTableWidgetItem* item) { edited(item->row()); });
  connect(table_, &QTableWidget::cellClicked, this,
          [this](int row, int) { measures_.visit(table_->item(row, Name)->text()); });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) {
    if (row >= 0 && table_->hasFocus()) {
      measures_.visit(table_->item(row, Name)->text());  // by the arrow keys
    }
  });
}

void MeasurePanel::addButtons(const QList<QAction*>& actions, int perRow) {
  addActionButtons(this, column_, actions, perRow);
}

void MeasurePanel::edit(const QString& name) {
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->item(row, Name)->text() == name) {
      table_->scrollToItem(table_->item(row, Name));
      table_->editItem(table_->item(row, Name));
    }
  }
}

void MeasurePanel::edited(int row) {
  const QString name = table_->item(row, Name)->data(kNameRole).toString();
  const QString wanted = table_->item(row, Name)->text();
  // Queued: the edit refills the table, which must not happen inside its own signal.
  QMetaObject::invokeMethod(
      this,
      [this, name, wanted] {
        measures_.rename(name, wanted);
        refresh();
      },
      Qt::QueuedConnection);
}

void MeasurePanel::refresh() {
  const QSignalBlocker quiet(table_);
  const auto count = static_cast<int>(measures_.all().size());
  if (table_->rowCount() != count) table_->setRowCount(count);
  for (int row = 0; row < count; ++row) fill(row);
  showSelection();
  QString notice = measures_.notice();
  if (notice.isEmpty() && count == 0)
    notice = tr("Nothing is measured: choose a tool of the menu Measure.");
  notice_->setText(notice);
  notice_->setVisible(!notice.isEmpty());
}

void MeasurePanel::fill(int row) {
  const Measurement& m = measures_.all()[static_cast<std::size_t>(row)];
  const QString name = QString::fromStdString(m.name);
  const bool earlier = measures_.isEarlier(m);
  QString value = measurementValue(m);
  if (earlier) value += QLatin1Char('\n') + tr("⚠ of earlier parameters");
  const std::array<QString, ColumnCount> texts{name, measurementTitle(m.kind), value};
  // Only what has changed: else a name that is being typed would be reset.
  const auto set = [](QTableWidgetItem* item, int role, const QVariant& wanted) {
    if (item->data(role) != wanted) item->setData(role, wanted);
  };
  for (int column = 0; column < ColumnCount; ++column) {
    QTableWidgetItem* item = table_->item(row, column);
    if (!item) {
      item = new QTableWidgetItem;
      item->setFlags(column == Name ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable
                                    : Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      table_->setItem(row, column, item);
    }
    set(item, Qt::DisplayRole, texts[static_cast<std::size_t>(column)]);
    set(item, Qt::ForegroundRole,
        earlier ? QVariant(QBrush(palette().color(QPalette::PlaceholderText))) : QVariant());
  }
  set(table_->item(row, Name), kNameRole, name);
}

void MeasurePanel::showSelection() {
  const Measurement* selected = measures_.selected();
  plot_->setMeasurement(selected);
  details_->setVisible(selected != nullptr);
  if (!selected) {
    table_->clearSelection();
    table_->setCurrentItem(nullptr);
    return;
  }
  details_->setText(measurementDetails(*selected));
  const auto row = static_cast<int>(selected - measures_.all().data());
  if (table_->currentRow() != row || !table_->item(row, Name)->isSelected())
    table_->setCurrentCell(row, Name);
}

}  // namespace angiomesh

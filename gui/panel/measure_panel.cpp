// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/measure_panel.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>

#include "gui/findings/case_measures.h"
#include "gui/findings/measurement_text.h"
#include "gui/panel/action_buttons.h"
#include "gui/panel/name_table.h"
#include "gui/panel/profile_plot.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

enum Column { Name, Kind, Value, ColumnCount };

}  // namespace

MeasurePanel::MeasurePanel(CaseMeasures& measures, QWidget* parent)
    : QWidget(parent), measures_(measures), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(4, 4, 4, 4);
  column_->setSpacing(3);
  table_ = named(new NameTable({tr("Name"), tr("Kind"), tr("Value")}, this), "measurements");
  column_->addWidget(table_, 1);
  connect(table_, &NameTable::visited, &measures_, &CaseMeasures::visit);
  connect(table_, &NameTable::renamed, this, [this](const QString& name, const QString& wanted) {
    measures_.rename(name, wanted);
    refresh();
  });
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

void MeasurePanel::addButtons(const QList<QAction*>& actions, int perRow) {
  addActionButtons(this, column_, actions, perRow);
}

void MeasurePanel::edit(const QString& name) { table_->editName(name); }

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
  for (int column = 0; column < ColumnCount; ++column) {
    QTableWidgetItem* item = table_->cell(row, column);
    NameTable::set(item, Qt::DisplayRole, texts[static_cast<std::size_t>(column)]);
    NameTable::set(
        item, Qt::ForegroundRole,
        earlier ? QVariant(QBrush(palette().color(QPalette::PlaceholderText))) : QVariant());
  }
  table_->setName(row, name);
}

void MeasurePanel::showSelection() {
  const Measurement* selected = measures_.selected();
  plot_->setMeasurement(selected);
  details_->setVisible(selected != nullptr);
  if (selected) details_->setText(measurementDetails(*selected));
  table_->showRow(selected ? static_cast<int>(selected - measures_.all().data()) : -1);
}

}  // namespace angiomesh

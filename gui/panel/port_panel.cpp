// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/port_panel.h"

#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/findings/case_ports.h"
#include "gui/panel/action_buttons.h"
#include "gui/panel/name_table.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

enum Column { Name, Diameter, Area, State, ColumnCount };
constexpr int kColourRole = Qt::UserRole + 1;
constexpr int kSwatch = 12;

QColor colourOf(const PortRow& port) {
  return QColor::fromRgbF(static_cast<float>(port.colour[0]), static_cast<float>(port.colour[1]),
                          static_cast<float>(port.colour[2]));
}

QIcon swatch(const QColor& colour) {
  QPixmap picture(kSwatch, kSwatch);
  picture.fill(colour);
  QIcon icon(picture);
  icon.addPixmap(picture, QIcon::Selected);  // else tinted as the selection is
  return icon;
}

/// A sign beside the words, so that the state does not rest on colour.
QString signOf(PortRow::State state) {
  switch (state) {
    case PortRow::State::Unknown:
      return QStringLiteral("○ ");
    case PortRow::State::Good:
      return QStringLiteral("● ");
    case PortRow::State::Advised:
      return QStringLiteral("⚠ ");
    case PortRow::State::Impossible:
      return QStringLiteral("✕ ");
  }
  return {};
}

QString number(double value, int decimals) {
  return value > 0.0 ? QLocale().toString(value, 'f', decimals) : QStringLiteral("–");
}

}  // namespace

PortPanel::PortPanel(CasePorts& ports, QWidget* parent)
    : QWidget(parent), ports_(ports), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(4, 4, 4, 4);
  column_->setSpacing(3);
  table_ = named(new NameTable({tr("Port"), tr("Ø mm"), tr("mm²"), tr("State")}, this), "ports");
  table_->horizontalHeaderItem(Diameter)->setToolTip(tr("Diameter of the circle of the same area"));
  column_->addWidget(table_, 1);
  connect(table_, &NameTable::visited, &ports_, &CasePorts::visit);
  connect(table_, &NameTable::renamed, this, [this](const QString& name, const QString& wanted) {
    ports_.rename(name, wanted);
    refresh();
  });
  notice_ = named(new QLabel(this), "portNotice");
  notice_->setWordWrap(true);
  column_->addWidget(notice_);
  connect(&ports_, &CasePorts::changed, this, &PortPanel::refresh);
  refresh();
}

void PortPanel::addButtons(const QList<QAction*>& actions, int perRow) {
  addActionButtons(this, column_, actions, perRow);
}

void PortPanel::edit(const QString& name) { table_->editName(name); }

void PortPanel::refresh() {
  const QSignalBlocker quiet(table_);
  const auto count = static_cast<int>(ports_.rows().size());
  if (table_->rowCount() != count) table_->setRowCount(count);
  for (int row = 0; row < count; ++row) fill(row);
  showSelection();
  QString notice = ports_.notice();
  if (notice.isEmpty() && count == 0) {
    notice = ports_.ready() ? tr("No ports: put the crosshair into a vessel and press Cut here, or "
                                 "right-click one.")
                            : tr("Run to Evolve, then cut the vessels here.");
  }
  notice_->setText(notice);
  notice_->setVisible(!notice.isEmpty());
}

void PortPanel::fill(int row) {
  const PortRow& port = ports_.rows()[static_cast<std::size_t>(row)];
  const std::array<QString, ColumnCount> texts{port.name, number(port.diameterMm(), 2),
                                               number(port.areaMm2, 1),
                                               signOf(port.state) + port.note};
  for (int column = 0; column < ColumnCount; ++column) {
    QTableWidgetItem* item = table_->cell(row, column);
    if (column == Diameter || column == Area)
      NameTable::set(item, Qt::TextAlignmentRole, QVariant(Qt::AlignRight | Qt::AlignVCenter));
    NameTable::set(item, Qt::DisplayRole, texts[static_cast<std::size_t>(column)]);
    NameTable::set(item, Qt::ToolTipRole, port.note);
  }
  table_->setName(row, port.name);
  QTableWidgetItem* name = table_->cell(row, Name);
  const QColor colour = colourOf(port);
  if (name->data(kColourRole) != colour) {
    name->setData(kColourRole, colour);
    name->setIcon(swatch(colour));
  }
}

void PortPanel::showSelection() {
  const PortRow* selected = ports_.selected();
  table_->showRow(selected ? static_cast<int>(selected - ports_.rows().data()) : -1);
}

}  // namespace angiomesh

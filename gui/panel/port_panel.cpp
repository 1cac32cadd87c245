// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/port_panel.h"

#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/findings/case_ports.h"
#include "gui/panel/action_buttons.h"
#include "gui/panel/named.h"

namespace angiomesh {

namespace {

enum Column { Name, Diameter, Area, State, ColumnCount };
constexpr int kNameRole = Qt::UserRole, kColourRole = Qt::UserRole + 1;
constexpr int kSwatch = 12;
constexpr int kNameWidth = 92;

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
  buildTable();
  notice_ = named(new QLabel(this), "portNotice");
  notice_->setWordWrap(true);
  column_->addWidget(notice_);
  connect(&ports_, &CasePorts::changed, this, &PortPanel::refresh);
  refresh();
}

void PortPanel::buildTable() {
  table_ = named(new QTableWidget(0, ColumnCount, this), "ports");
  table_->setHorizontalHeaderLabels({tr("Port"), tr("Ø mm"), tr("mm²"), tr("State")});
  table_->horizontalHeaderItem(Diameter)->setToolTip(tr("Diameter of the circle of the same area"));
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(Name, QHeaderView::Interactive);
  header->resizeSection(Name, kNameWidth);
  header->setSectionResizeMode(State, QHeaderView::Stretch);
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
          [this](int row, int) { ports_.visit(table_->item(row, Name)->text()); });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) {
    if (row >= 0 && table_->hasFocus()) {
      ports_.visit(table_->item(row, Name)->text());  // by the arrow keys
    }
  });
}

void PortPanel::addButtons(const QList<QAction*>& actions, int perRow) {
  addActionButtons(this, column_, actions, perRow);
}

void PortPanel::edit(const QString& name) {
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->item(row, Name)->text() == name) {
      table_->scrollToItem(table_->item(row, Name));
      table_->editItem(table_->item(row, Name));
    }
  }
}

void PortPanel::edited(int row) {
  const QString name = table_->item(row, Name)->data(kNameRole).toString();
  const QString wanted = table_->item(row, Name)->text();
  // Queued: the edit refills the table, which must not happen inside its own signal.
  QMetaObject::invokeMethod(
      this,
      [this, name, wanted] {
        ports_.rename(name, wanted);
        refresh();
      },
      Qt::QueuedConnection);
}

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
  // Only what has changed: else a name that is being typed would be reset.
  const auto set = [](QTableWidgetItem* item, int role, const QVariant& value) {
    if (item->data(role) != value) item->setData(role, value);
  };
  for (int column = 0; column < ColumnCount; ++column) {
    QTableWidgetItem* item = table_->item(row, column);
    if (!item) {
      item = new QTableWidgetItem;
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      if (column == Diameter || column == Area)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
    set(item, Qt::DisplayRole, texts[static_cast<std::size_t>(column)]);
    set(item, Qt::ToolTipRole, port.note);
  }
  QTableWidgetItem* name = table_->item(row, Name);
  set(name, kNameRole, port.name);
  const QColor colour = colourOf(port);
  if (name->data(kColourRole) != colour) {
    name->setData(kColourRole, colour);
    name->setIcon(swatch(colour));
  }
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable;
  if (name->flags() != flags) name->setFlags(flags);
}

void PortPanel::showSelection() {
  const PortRow* selected = ports_.selected();
  if (!selected) {
    table_->clearSelection();
    table_->setCurrentItem(nullptr);
    return;
  }
  const auto row = static_cast<int>(selected - ports_.rows().data());
  if (table_->currentRow() != row || !table_->item(row, Name)->isSelected())
    table_->setCurrentCell(row, Name);
}

}  // namespace angiomesh

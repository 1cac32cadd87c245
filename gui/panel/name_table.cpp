// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/name_table.h"

#include <QHeaderView>

namespace angiomesh {

namespace {

constexpr int kNameRole = Qt::UserRole;
constexpr int kNameWidth = 92;

}  // namespace

NameTable::NameTable(const QStringList& titles, QWidget* parent)
    : QTableWidget(0, static_cast<int>(titles.size()), parent) {
  setHorizontalHeaderLabels(titles);
  QHeaderView* header = horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(kNameColumn, QHeaderView::Interactive);
  header->resizeSection(kNameColumn, kNameWidth);
  header->setSectionResizeMode(columnCount() - 1, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setWordWrap(true);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setTabKeyNavigation(false);
  connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* changed) {
    const QTableWidgetItem* name = item(changed->row(), kNameColumn);
    const QString known = name->data(kNameRole).toString();
    QMetaObject::invokeMethod(
        this, [this, known, wanted = name->text()] { Q_EMIT renamed(known, wanted); },
        Qt::QueuedConnection);
  });
  connect(this, &QTableWidget::cellClicked, this,
          [this](int row, int) { Q_EMIT visited(item(row, kNameColumn)->text()); });
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) {
    if (row >= 0 && hasFocus()) Q_EMIT visited(item(row, kNameColumn)->text());
  });
}

void NameTable::editName(const QString& name) {
  for (int row = 0; row < rowCount(); ++row) {
    if (item(row, kNameColumn)->text() == name) {
      scrollToItem(item(row, kNameColumn));
      editItem(item(row, kNameColumn));
    }
  }
}

QTableWidgetItem* NameTable::cell(int row, int column) {
  QTableWidgetItem* at = item(row, column);
  if (at != nullptr) return at;
  at = new QTableWidgetItem;
  const Qt::ItemFlags shown = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  at->setFlags(column == kNameColumn ? shown | Qt::ItemIsEditable : shown);
  setItem(row, column, at);
  return at;
}

void NameTable::set(QTableWidgetItem* item, int role, const QVariant& value) {
  if (item->data(role) != value) item->setData(role, value);
}

void NameTable::setName(int row, const QString& name) {
  set(cell(row, kNameColumn), kNameRole, name);
}

void NameTable::showRow(int row) {
  if (row < 0) {
    clearSelection();
    setCurrentItem(nullptr);
  } else if (currentRow() != row || !item(row, kNameColumn)->isSelected()) {
    setCurrentCell(row, kNameColumn);
  }
}

}  // namespace angiomesh

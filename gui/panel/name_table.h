// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTableWidget>

namespace angiomesh {

/// A table of named things, one a row, the names first. Names are edited in place; a click on a row
/// visits it, and so do the arrow keys.
class NameTable : public QTableWidget {
  Q_OBJECT

 public:
  static constexpr int kNameColumn = 0;

  explicit NameTable(const QStringList& titles, QWidget* parent = nullptr);

  /// Opens the editor of a name.
  void editName(const QString& name);
  /// The item of a cell, which is made where there is none; only names can be edited.
  QTableWidgetItem* cell(int row, int column);
  /// Sets what has changed only: else a name that is being typed would be reset.
  static void set(QTableWidgetItem* item, int role, const QVariant& value);
  /// That the row is known by, until it is edited.
  void setName(int row, const QString& name);
  /// Selects a row; -1: none.
  void showRow(int row);

 Q_SIGNALS:
  void visited(const QString& name);
  /// Queued: whoever hears it may fill the table anew.
  void renamed(const QString& name, const QString& wanted);
};

}  // namespace angiomesh

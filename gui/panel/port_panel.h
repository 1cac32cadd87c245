// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QLabel;
class QVBoxLayout;

namespace angiomesh {

class CasePorts;
class NameTable;

/// The inlets and outlets: name, diameter, area and what there is to say of each. Names are
/// edited in place; a click on a row takes the panes there.
class PortPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PortPanel(CasePorts& ports, QWidget* parent = nullptr);

  /// Opens the editor of a port's name.
  void edit(const QString& name);
  /// Buttons for the window's actions, in rows of `perRow`.
  void addButtons(const QList<QAction*>& actions, int perRow);

 private:
  void refresh();
  void fill(int row);
  void showSelection();

  CasePorts& ports_;
  QVBoxLayout* column_;
  NameTable* table_;
  QLabel* notice_;
};

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QLabel;
class QVBoxLayout;

namespace angiomesh {

class CaseMeasures;
class NameTable;
class ProfilePlot;

/// The measurements of the case: name, kind and value of each, and of the one selected how it came
/// about, with a plot where it goes along a vessel. Names are edited in place; a click on a row
/// takes the panes there.
class MeasurePanel : public QWidget {
  Q_OBJECT

 public:
  explicit MeasurePanel(CaseMeasures& measures, QWidget* parent = nullptr);

  /// Opens the editor of a name.
  void edit(const QString& name);
  /// Buttons for the window's actions, in rows of `perRow`.
  void addButtons(const QList<QAction*>& actions, int perRow);

 Q_SIGNALS:
  void placePicked(double x, double y, double z);  ///< in the plot, mm LPS

 private:
  void refresh();
  void fill(int row);
  void showSelection();

  CaseMeasures& measures_;
  QVBoxLayout* column_;
  NameTable* table_;
  ProfilePlot* plot_;
  QLabel* details_;
  QLabel* notice_;
};

}  // namespace angiomesh

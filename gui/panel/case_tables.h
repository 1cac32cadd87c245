// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace angiomesh {

class CaseController;

/// The seeds set by hand, each of which can be removed, and how many were found besides.
class SeedList : public QWidget {
  Q_OBJECT

 public:
  explicit SeedList(CaseController& controller, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseController& controller_;
  QLabel* summary_;
  QListWidget* list_;
  QPushButton* remove_;
};

/// The connected parts of the segmentation, largest first; those ticked off are not meshed.
class ComponentTable : public QWidget {
  Q_OBJECT

 public:
  explicit ComponentTable(CaseController& controller, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseController& controller_;
  QLabel* summary_;
  QTableWidget* table_;
};

/// Iteration and change of the evolution, with pause, single step and finish.
class EvolutionControls : public QWidget {
  Q_OBJECT

 public:
  explicit EvolutionControls(CaseController& controller, QWidget* parent = nullptr);

 private:
  void refresh();
  void showProgress();

  CaseController& controller_;
  QLabel* text_;
  QPushButton* pause_;
  QPushButton* step_;
  QPushButton* finish_;
};

}  // namespace angiomesh

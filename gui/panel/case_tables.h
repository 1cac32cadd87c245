// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>
#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace angiomesh {

struct CaseModels;

/// The seeds set by hand, each of which can be removed, and how many were found besides.
class SeedList : public QWidget {
  Q_OBJECT

 public:
  explicit SeedList(CaseModels& models, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseModels& models_;
  QLabel* summary_;
  QListWidget* list_;
  QPushButton* remove_;
};

/// The brush and the corrections that were made, each of which can be taken back.
class CorrectionList : public QWidget {
  Q_OBJECT

 public:
  explicit CorrectionList(CaseModels& models, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseModels& models_;
  QDoubleSpinBox* radius_;
  QCheckBox* toEdge_;
  QListWidget* list_;
  QPushButton* remove_;
};

/// The connected parts of the segmentation, largest first; those ticked off are not meshed.
class ComponentTable : public QFrame {
  Q_OBJECT

 public:
  explicit ComponentTable(CaseModels& models, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();

  CaseModels& models_;
  QLabel* summary_;
  QTableWidget* table_ = nullptr;
};

/// Iteration and change of the evolution, with pause, single step and finish.
class EvolutionControls : public QWidget {
  Q_OBJECT

 public:
  explicit EvolutionControls(CaseModels& models, QWidget* parent = nullptr);

 private:
  void refresh();
  void showProgress();

  CaseModels& models_;
  QLabel* text_;
  QPushButton* pause_;
  QPushButton* step_;
  QPushButton* finish_;
};

}  // namespace angiomesh

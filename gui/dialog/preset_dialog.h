// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace angiomesh {

struct CaseModels;

/// Asks for a name and a sentence, and keeps the present parameters as an own preset.
class PresetDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PresetDialog(CaseModels& models, QWidget* parent = nullptr);

 private:
  void refresh();
  void keep();

  CaseModels& models_;
  QLineEdit* name_;
  QLineEdit* about_;
  QLabel* note_;
  QPushButton* save_;
};

}  // namespace angiomesh

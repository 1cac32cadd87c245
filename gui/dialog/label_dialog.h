// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <vector>

#include "gui/dialog/open_questions.h"

class QTableWidget;

namespace angiomesh {

/// The labels of a segmentation, one row each: one is chosen by a double click, or by Enter. The
/// image may be opened as a scan instead.
class LabelDialog : public QDialog {
  Q_OBJECT

 public:
  LabelDialog(const std::vector<Label>& labels, double voxelMm3, QWidget* parent = nullptr);

  [[nodiscard]] LabelAnswer answer() const;

 private:
  QTableWidget* table_;
  bool asScan_ = false;
};

}  // namespace angiomesh

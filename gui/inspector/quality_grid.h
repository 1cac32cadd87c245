// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTableWidget>

#include "gui/model/case_models.h"

namespace angiomesh {

/// The measures of the meshes side by side; where one is better than another, the best of the row
/// is bold and has a star.
class QualityGrid : public QTableWidget {
  Q_OBJECT

 public:
  explicit QualityGrid(CaseModels& models, QWidget* parent = nullptr);

 private:
  void build();
  void refresh();
  void refreshVerified();

  CaseModels& models_;
};

}  // namespace angiomesh

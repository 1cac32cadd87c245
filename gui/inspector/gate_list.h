// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/quality/quality_gates.h"
#include "gui/model/view_state.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace angiomesh {

/// Whether the mesh shown is fit for a solver and for printing: each threshold with what the mesh
/// has, and where it misses one, why that matters and what helps. Buttons change the parameter that
/// helps; a run does the rest.
class GateList : public QWidget {
  Q_OBJECT

 public:
  GateList(CaseModels& models, ViewState& state, QWidget* parent = nullptr);

 private:
  struct Part {
    const QualityGate* gate;
    QLabel* heading;
    QLabel* rows;
  };
  struct Fix {
    GateFix fix;
    QPushButton* button;
  };
  void addFixes(QVBoxLayout* column);
  void refresh();
  void refreshFixes(const MeshQuality* quality);
  /// What helps the mesh shown.
  [[nodiscard]] GateFix fixOf(const GateCheck& check) const;
  /// Whether its parameter can still be changed that way.
  [[nodiscard]] bool canApply(GateFix fix) const;
  void apply(GateFix fix);

  CaseModels& models_;
  ViewState& state_;
  std::vector<Part> parts_;
  std::vector<Fix> fixes_;
  QLabel* loops_ = nullptr;
  QPushButton* closeLoops_ = nullptr;
  QLabel* then_ = nullptr;
};

}  // namespace angiomesh

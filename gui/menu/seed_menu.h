// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <optional>

#include "gui/model/case_models.h"

class QMenu;

namespace angiomesh {

/// What the right-click menu of a pane has for seeds.
class SeedMenu : public QObject {
  Q_OBJECT

 public:
  explicit SeedMenu(CaseModels& models, QObject* parent = nullptr);

  /// See PortMenu::menuMade().
  void addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place);

 private:
  /// The seed by hand nearest to a place, if it is near; -1: there is none.
  [[nodiscard]] int seedNear(const Eigen::Vector3d& lps) const;

  CaseModels& models_;
};

}  // namespace angiomesh

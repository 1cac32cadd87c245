// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/seed_menu.h"

#include <QAction>
#include <QMenu>

namespace angiomesh {

namespace {

/// A click this near to a seed, voxels, means it.
constexpr double kNearVoxels = 3.0;

}  // namespace

SeedMenu::SeedMenu(CaseModels& models, QObject* parent) : QObject(parent), models_(models) {}

void SeedMenu::addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place) {
  const Parameters& params = models_.document.parameters();
  if (!models_.document.hasCase() || isSegmented(params)) return;
  QMenu* seeds = menu->addMenu(tr("Seeds"));
  const auto add = [&](const char* name, const QString& text, const auto& slot) {
    QAction* action = seeds->addAction(text, this, slot);
    action->setObjectName(QLatin1String(name));
    action->setEnabled(place.has_value());
    return action;
  };
  add("seedHere", tr("Put a seed here"), [this, place] { models_.document.addSeed(*place); });
  const int near = place ? seedNear(*place) : -1;
  add("removeSeedHere", tr("Remove this seed"), [this, near] {
    models_.document.removeSeed(near);
  })->setEnabled(near >= 0);
  add("onlyThisVessel", tr("This vessel only"), [this, place] {
    models_.document.keepOnlyVesselAt(*place);
  })->setToolTip(tr("The only seed is here, and parts without a seed are left out"));
  seeds->setToolTipsVisible(true);
}

int SeedMenu::seedNear(const Eigen::Vector3d& lps) const {
  const std::vector<Eigen::Vector3d> seeds = models_.document.seeds();
  double least = kNearVoxels * models_.document.image()->geometry.voxelMm();
  int nearest = -1;
  for (std::size_t n = 0; n < seeds.size(); ++n) {
    const double away = (seeds[n] - lps).norm();
    if (away > least) continue;
    least = away;
    nearest = static_cast<int>(n);
  }
  return nearest;
}

}  // namespace angiomesh

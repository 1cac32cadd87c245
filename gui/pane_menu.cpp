// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pane_menu.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QWidgetAction>
#include <array>

#include "gui/panel/named.h"
#include "gui/panel/view_grid.h"

namespace angiomesh {

namespace {

constexpr double kThinnestSlabMm = 0.1;

}  // namespace

PaneMenu::PaneMenu(ViewState& state, QObject* parent) : QObject(parent), state_(state) {}

void PaneMenu::addTo(QMenu* menu, const std::optional<Eigen::Vector3d>&, int plane) {
  if (plane == ViewGrid::kNoSlice) return;
  menu->addSeparator();
  addSlab(menu, plane);
}

void PaneMenu::addSlab(QMenu* menu, int plane) {
  QMenu* slabs = named(menu->addMenu(tr("Slab of this pane")), "slabMenu");
  const std::array<QString, kSlabModeCount> titles{tr("Off"), tr("MIP"), tr("MinIP"), tr("Mean")};
  for (int i = 0; i < kSlabModeCount; ++i) {
    const auto mode = static_cast<SlabMode>(i);
    QAction* action = slabs->addAction(titles[static_cast<std::size_t>(i)], this, [=, this] {
      state_.setSlab(plane, {mode, state_.slab(plane).thicknessMm});
    });
    action->setCheckable(true);
    action->setChecked(state_.slab(plane).mode == mode);
  }
  slabs->addSeparator();
  auto* row = new QWidget(slabs);
  auto* layout = new QHBoxLayout(row);
  layout->addWidget(new QLabel(tr("Thickness"), row));
  auto* thickness = named(new QDoubleSpinBox(row), "paneThickness");
  thickness->setRange(kThinnestSlabMm, kThickestSlabMm);
  thickness->setDecimals(1);
  thickness->setSuffix(tr(" mm"));
  thickness->setKeyboardTracking(false);
  thickness->setValue(state_.slab(plane).thicknessMm);
  connect(thickness, &QDoubleSpinBox::valueChanged, this, [this, plane](double mm) {
    state_.setSlab(plane, {state_.slab(plane).mode, mm});
  });
  layout->addWidget(thickness);
  auto* action = new QWidgetAction(slabs);
  action->setDefaultWidget(row);
  slabs->addAction(action);
  QAction* all = slabs->addAction(tr("The same in all panes"), this,
                                  [this, plane] { state_.setSlabs(state_.slab(plane)); });
  all->setObjectName("sameSlabs");
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/pane_menu.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QWidgetAction>
#include <array>

#include "gui/menu/window_actions.h"
#include "gui/pane/surface_feed.h"
#include "gui/pane/view_grid.h"
#include "gui/view/named.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

constexpr double kThinnestSlabMm = 0.1;

}  // namespace

PaneMenu::PaneMenu(QMainWindow* window, ViewState& state, ViewGrid& views, PartEdits& parts)
    : QObject(window), window_(window), state_(state), views_(views), parts_(parts) {}

void PaneMenu::addTo(QMenu* viewMenu) {
  QAction* back = addMenuAction(window_, viewMenu, "showParts", tr("Show hidden parts"),
                                QKeySequence(tr("Ctrl+Shift+H")),
                                [this] { views_.surfaceFeed()->showAllParts(); });
  const auto refresh = [this, back] { back->setEnabled(views_.surfaceFeed()->hidesParts()); };
  connect(views_.surfaceFeed(), &SurfaceFeed::arrived, this, refresh);
  refresh();
}

void PaneMenu::addParts(QMenu* menu, const std::optional<Eigen::Vector3d>& place) {
  const std::optional<std::size_t> triangle = views_.surface()->clickedTriangle();
  QAction* hide = menu->addAction(tr("Hide this part"), this,
                                  [this, triangle] { views_.surfaceFeed()->hidePart(*triangle); });
  hide->setObjectName("hidePart");
  hide->setEnabled(place && triangle && views_.surfaceFeed()->settled());
  QAction* keep =
      menu->addAction(tr("Keep only this part"), this, [this, place] { parts_.keepOnly(*place); });
  keep->setObjectName("keepPart");
  keep->setToolTip(tr("Ticks all other parts off"));
  QAction* remove =
      menu->addAction(tr("Remove this part"), this, [this, place] { parts_.remove(*place); });
  remove->setObjectName("removePart");
  remove->setToolTip(tr("Ticks it off"));
  for (QAction* action : {keep, remove}) action->setEnabled(place && parts_.ready());
  menu->addAction(actionOf(window_, "showParts"));
}

void PaneMenu::addTo(QMenu* menu, const std::optional<Eigen::Vector3d>& place, int plane) {
  menu->addSeparator();
  if (plane == ViewGrid::kNoSlice)
    addParts(menu, place);
  else
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

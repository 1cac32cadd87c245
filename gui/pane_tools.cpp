// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pane_tools.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolBar>
#include <array>
#include <cmath>

#include "gui/menu/window_actions.h"
#include "gui/model/step_text.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr int kSliderWidth = 80;
/// In the order of the chooser, after "none".
constexpr std::array<Layer, 2> kOverlays{Layer::Vesselness, Layer::Speed};
constexpr std::array<const char*, 2> kActions{"overlayVesselness", "overlaySpeed"};
constexpr std::array<const char*, 2> kKeys{"V", "Shift+V"};

int rowOf(const std::optional<Layer>& overlay) {
  for (std::size_t i = 0; i < kOverlays.size(); ++i)
    if (overlay == kOverlays[i]) return static_cast<int>(i) + 1;
  return 0;
}

std::optional<Layer> overlayOf(int row) {
  return row > 0 ? std::optional(kOverlays[static_cast<std::size_t>(row - 1)]) : std::nullopt;
}

}  // namespace

PaneTools::PaneTools(QMainWindow* window, CaseModels& models, ViewState& state)
    : QObject(window), window_(window), models_(models), state_(state) {}

void PaneTools::addTo(QMenu* view) {
  QMenu* overlays = view->addMenu(tr("Overlay"));
  for (std::size_t i = 0; i < kOverlays.size(); ++i) {
    const Layer layer = kOverlays[i];
    addMenuToggle(
        window_, overlays, kActions[i], layerTitle(layer), QKeySequence(QLatin1String(kKeys[i])),
        [this, layer](bool on) { state_.setOverlay(on ? std::optional(layer) : std::nullopt); });
  }
  addMenuToggle(window_, view, "slices3d", tr("Slices in 3D"), QKeySequence(tr("Ctrl+Shift+D")),
                [this](bool on) { state_.setSlices3d(on); });
  addPlanes(view->addMenu(tr("Slice planes")));
}

void PaneTools::addPlanes(QMenu* menu) {
  addMenuToggle(window_, menu, "patientAxes", tr("Along the patient's axes"),
                QKeySequence(tr("Ctrl+Shift+A")), [this](bool on) { state_.setPatientAxes(on); });
  addMenuAction(window_, menu, "resetTurn", tr("Turn back"), QKeySequence(Qt::Key_T),
                [this] { state_.resetTurn(); });
}

void PaneTools::addTo(QToolBar* bar) {
  bar->addWidget(new QLabel(tr("  Overlay "), bar));
  overlay_ = named(new QComboBox(bar), "overlay");
  overlay_->addItem(tr("none"));
  for (const Layer layer : kOverlays) overlay_->addItem(layerTitle(layer));
  bar->addWidget(overlay_);
  opacity_ = named(new QSlider(Qt::Horizontal, bar), "overlayOpacity");
  opacity_->setRange(0, 100);
  opacity_->setFixedWidth(kSliderWidth);
  opacity_->setToolTip(tr("Opacity of the overlay"));
  bar->addWidget(opacity_);
  connect(overlay_, &QComboBox::activated, this,
          [this](int row) { state_.setOverlay(overlayOf(row)); });
  connect(opacity_, &QSlider::valueChanged, this,
          [this](int percent) { state_.setOverlayOpacity(percent / 100.0); });
  connect(&state_, &ViewState::changed, this, &PaneTools::refresh);
  connect(&models_.files, &CaseFiles::caseChanged, this, &PaneTools::refresh);
  refresh();
}

void PaneTools::refresh() {
  const bool any = models_.document.hasCase();
  const QSignalBlocker quietOverlay(overlay_);
  const QSignalBlocker quietOpacity(opacity_);
  const int row = rowOf(state_.overlay());
  overlay_->setCurrentIndex(row);
  overlay_->setEnabled(any);
  opacity_->setValue(static_cast<int>(std::lround(100.0 * state_.overlayOpacity())));
  opacity_->setEnabled(any && row > 0);
  for (std::size_t i = 0; i < kActions.size(); ++i)
    actionOf(window_, kActions[i])->setChecked(row == static_cast<int>(i) + 1);
  actionOf(window_, "slices3d")->setChecked(state_.slices3d());
  actionOf(window_, "patientAxes")->setChecked(state_.turn().patientAxes);
  enableActions(window_, {"patientAxes", "overlayVesselness", "overlaySpeed"}, any);
  enableActions(window_, {"resetTurn"}, any && state_.turn().turned());
}

}  // namespace angiomesh

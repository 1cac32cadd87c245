// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/view_state.h"

#include <cstddef>

namespace angiomesh {

ViewState::ViewState(CaseController& controller, QObject* parent)
    : QObject(parent), controller_(controller) {
  const auto reset = [this] {
    layer_ = Layer::Source;
    tool_ = Tool::Navigate;
    for (int i = 0; i < kLayerCount; ++i) {
      windowLevels_[static_cast<std::size_t>(i)] = controller_.windowLevel(static_cast<Layer>(i));
    }
    Q_EMIT changed();
  };
  reset();
  connect(&controller_, &CaseController::caseChanged, this, reset);
}

void ViewState::setLayer(Layer layer) { set(layer_, layer); }

std::pair<double, double> ViewState::windowLevel() const {
  return windowLevels_[static_cast<std::size_t>(layer_)];
}

void ViewState::setWindowLevel(double window, double level) {
  set(windowLevels_[static_cast<std::size_t>(layer_)], std::pair(window, level));
}

void ViewState::resetWindowLevel() {
  const auto [window, level] = controller_.windowLevel(layer_);
  setWindowLevel(window, level);
}

void ViewState::setSlab(SlabMode mode, double thicknessMm) {
  if (mode == slabMode_ && thicknessMm == slabThicknessMm_) {
    return;
  }
  slabMode_ = mode;
  slabThicknessMm_ = thicknessMm;
  Q_EMIT changed();
}

}  // namespace angiomesh

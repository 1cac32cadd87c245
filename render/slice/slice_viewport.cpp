// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_viewport.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace angiomesh {

using Eigen::Vector2d;

Vector2d SliceViewport::size() const {
  if (renderer_->GetRenderWindow() == nullptr) return {1.0, 1.0};
  const int* s = renderer_->GetSize();
  return {std::max(1, s[0]), std::max(1, s[1])};
}

Vector2d SliceViewport::toScene(double displayX, double displayY) const {
  const int* origin = renderer_->GetRenderWindow() != nullptr ? renderer_->GetOrigin() : nullptr;
  const Vector2d corner = origin != nullptr ? Vector2d(origin[0], origin[1]) : Vector2d(0.0, 0.0);
  return centre_ + mmPerPixel_ * (Vector2d(displayX, displayY) - corner - 0.5 * size());
}

void SliceViewport::fit(const SlicePlane& plane) {
  fitted_ = true;
  const Vector2d pane = size();
  lastSize_ = {static_cast<int>(pane[0]), static_cast<int>(pane[1])};
  const Vector2d pixel(plane.pixelWidthMm(), plane.pixelHeightMm());
  const Vector2d extent(pixel[0] * plane.width(), pixel[1] * plane.height());
  centre_ = 0.5 * (extent - pixel);
  mmPerPixel_ = extent.cwiseQuotient(pane).maxCoeff();
}

void SliceViewport::followSize(const SlicePlane& plane) {
  const Vector2d pane = size();
  const std::array<int, 2> now{static_cast<int>(pane[0]), static_cast<int>(pane[1])};
  if (fitted_ && now != lastSize_) fit(plane);
}

void SliceViewport::zoom(double factor, double displayX, double displayY, const SlicePlane& plane) {
  const Vector2d fixed = toScene(displayX, displayY);
  const double wanted = mmPerPixel_ / factor;
  // From a hundredth of a pixel's size to a thousand volumes: beyond, numbers lose their meaning.
  const double smallest = 0.001 * std::min(plane.pixelWidthMm(), plane.pixelHeightMm());
  const double changed = std::clamp(wanted, smallest, 1e5 * smallest);
  centre_ = fixed + (centre_ - fixed) * (changed / mmPerPixel_);
  mmPerPixel_ = changed;
  fitted_ = false;
}

void SliceViewport::pan(double displayDx, double displayDy) {
  centre_ -= mmPerPixel_ * Vector2d(displayDx, displayDy);
  fitted_ = false;
}

void SliceViewport::apply() const {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetFocalPoint(centre_[0], centre_[1], 0.0);
  camera->SetPosition(centre_[0], centre_[1], 100.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.5 * size()[1] * mmPerPixel_);
  camera->SetClippingRange(50.0, 150.0);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/software_caster.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/stage/conversion.h"
#include "render/surface/ray_caster.h"

namespace angiomesh {

namespace {

using Eigen::Vector3d;

/// In front of all that was drawn, which the rays have ended at already.
constexpr float kNearest = 1e-4F;

CastView viewOf(vtkRenderer* renderer, const Geometry& grid, const std::array<int, 2>& size) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vector3d eye(camera->GetPosition());
  const Vector3d forward(camera->GetDirectionOfProjection());
  const Vector3d right = forward.cross(Vector3d(camera->GetViewUp())).normalized();
  const Vector3d up = right.cross(forward);
  const double slope = std::tan(0.5 * camera->GetViewAngle() * std::numbers::pi / 180.0);
  const double aspect = static_cast<double>(renderer->GetSize()[0]) / renderer->GetSize()[1];
  const auto steps = [&](const Vector3d& mm) {
    return Vector3d(grid.toIndex(eye + mm) - grid.toIndex(eye));
  };
  CastView view;
  view.eye = grid.toIndex(eye);
  view.forward = steps(forward);
  view.right = steps(slope * aspect * right);
  view.up = steps(slope * up);
  const Vector3d light = (up - 0.6 * right - 1.6 * forward).normalized();
  view.lightAxes = grid.direction.transpose() * light;
  view.eyeAxes = grid.direction.transpose() * -forward;
  view.width = size[0];
  view.height = size[1];
  return view;
}

}  // namespace

vtkStandardNewMacro(SoftwareCaster);

SoftwareCaster::SoftwareCaster()
    : display_(vtkSmartPointer<vtkRayCastImageDisplayHelper>::Take(
          vtkRayCastImageDisplayHelper::New())) {
  display_->PreMultipliedColorsOn();
}

SoftwareCaster::~SoftwareCaster() = default;

void SoftwareCaster::setVolume(std::shared_ptr<const DrawnVolume> volume) {
  if (volume == drawn_) return;
  drawn_ = std::move(volume);
  SetInputData(drawn_ ? toImageData(drawn_->image).Get() : static_cast<vtkImageData*>(nullptr));
  Modified();
}

void SoftwareCaster::setLook(const VolumeLook& look) {
  look_ = look;
  Modified();
}

void SoftwareCaster::setSampling(double stepMm, double pixels) {
  if (stepMm == stepMm_ && pixels == pixels_) return;
  stepMm_ = stepMm;
  pixels_ = pixels;
  Modified();
}

void SoftwareCaster::setEndsAtSurfaces(bool ends) {
  if (std::exchange(endsAtSurfaces_, ends) != ends) Modified();
}

std::vector<float> SoftwareCaster::depthsOf(vtkRenderer* renderer) const {
  if (!endsAtSurfaces_) return {};
  const int width = renderer->GetSize()[0];
  const int height = renderer->GetSize()[1];
  const int* corner = renderer->GetOrigin();
  std::vector<float> buffer(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  renderer->GetRenderWindow()->GetZbufferData(corner[0], corner[1], corner[0] + width - 1,
                                              corner[1] + height - 1, buffer.data());
  double nearMm = 0.0;
  double farMm = 0.0;
  renderer->GetActiveCamera()->GetClippingRange(nearMm, farMm);
  std::vector<float> depths;
  depths.reserve(static_cast<std::size_t>(pictureSize_[0]) *
                 static_cast<std::size_t>(pictureSize_[1]));
  const auto pixelAt = [](int n, int count, int pixels) {
    return static_cast<std::size_t>((n + 0.5) * pixels / count);
  };
  for (int y = 0; y < pictureSize_[1]; ++y) {
    const float* row =
        buffer.data() + pixelAt(y, pictureSize_[1], height) * static_cast<std::size_t>(width);
    for (int x = 0; x < pictureSize_[0]; ++x) {
      const double depth = row[pixelAt(x, pictureSize_[0], width)];
      depths.push_back(static_cast<float>(nearMm * farMm / (farMm - depth * (farMm - nearMm))));
    }
  }
  return depths;
}

SoftwareCaster::Seen SoftwareCaster::seenBy(vtkRenderer* renderer) {
  Seen seen;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetPosition(&seen.camera[0]);
  camera->GetFocalPoint(&seen.camera[3]);
  camera->GetViewUp(&seen.camera[6]);
  seen.camera[9] = camera->GetViewAngle();
  seen.size = {renderer->GetSize()[0], renderer->GetSize()[1]};
  seen.changed = GetMTime();
  for (std::size_t a = 0; a < 2; ++a)
    pictureSize_[a] = std::max(1, static_cast<int>(std::lround(seen.size[a] / pixels_)));
  seen.depths = depthsOf(renderer);
  return seen;
}

void SoftwareCaster::cast(vtkRenderer* renderer) {
  picture_ = castRays(*drawn_, look_, viewOf(renderer, drawn_->image->geometry, pictureSize_),
                      stepMm_, seen_.depths);
}

void SoftwareCaster::Render(vtkRenderer* renderer, vtkVolume* volume) {
  if (!drawn_ || look_.transfer.empty()) return;
  Seen now = seenBy(renderer);
  if (now != seen_) {
    const auto begin = std::chrono::steady_clock::now();
    seen_ = std::move(now);
    cast(renderer);
    TimeToDraw = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  std::array<int, 2> whole = pictureSize_;
  std::array<int, 2> corner{0, 0};
  display_->RenderTexture(volume, renderer, whole.data(), whole.data(), whole.data(), corner.data(),
                          kNearest, picture_.data());
}

void SoftwareCaster::ReleaseGraphicsResources(vtkWindow* window) {
  display_->ReleaseGraphicsResources(window);
  vtkVolumeMapper::ReleaseGraphicsResources(window);
}

}  // namespace angiomesh

// SPDX-License-Identifier: BSD-3-Clause
#include "render/stage/stage.h"

#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace angiomesh {

void setStage(vtkRenderer* renderer) {
  renderer->SetBackground(0.05, 0.06, 0.08);
  renderer->SetBackground2(0.13, 0.15, 0.19);
  renderer->GradientBackgroundOn();
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.85);
  lights->SetKeyToFillRatio(3.0);
  lights->SetKeyToHeadRatio(4.0);
  lights->SetKeyToBackRatio(4.0);
  lights->AddLightsToRenderer(renderer);
}

void styleText(vtkTextActor* text, int size) {
  vtkTextProperty* property = text->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetColor(0.93, 0.90, 0.72);
  property->SetShadow(1);
  property->SetLineSpacing(1.15);
  text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
}

Viewpoint firstViewpoint(const std::array<double, 6>& bounds) {
  constexpr double flat = 0.4;
  Viewpoint view;
  if (bounds[5] - bounds[4] < flat * (bounds[3] - bounds[2])) {
    view.from = {0.0, 0.0, -1.0};
    view.up = {0.0, -1.0, 0.0};
  }
  return view;
}

std::optional<Viewpoint> viewpointFrom(char side) {
  static const std::map<char, Viewpoint> sides{
      {'A', {{0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}}}, {'P', {{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}},
      {'L', {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}},  {'R', {{-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}},
      {'S', {{0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}}}, {'I', {{0.0, 0.0, -1.0}, {0.0, -1.0, 0.0}}}};
  const auto found = sides.find(side);
  return found == sides.end() ? std::nullopt : std::optional(found->second);
}

bool drawnBySoftware(vtkRenderer* renderer) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr) return false;
  const std::string& name = window->GetState()->GetRenderer();
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software"})
    if (name.find(software) != std::string::npos) return true;
  return false;
}

bool fitCamera(vtkRenderer* renderer) {
  std::array<double, 6> bounds{};
  renderer->ComputeVisiblePropBounds(bounds.data());
  if (bounds[0] > bounds[1]) return false;
  fitCamera(renderer, bounds);
  return true;
}

void fitCamera(vtkRenderer* renderer, const std::array<double, 6>& bounds) {
  const std::array<double, 6>& b = bounds;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(viewAngleDegrees);
  Eigen::Vector3d forward;
  Eigen::Vector3d up;
  camera->GetDirectionOfProjection(forward.data());
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up.data());
  const Eigen::Vector3d right = forward.cross(up);
  const int* size = renderer->GetRenderWindow() != nullptr ? renderer->GetSize() : nullptr;
  const double aspect =
      size != nullptr && size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
  const double slope = std::tan(0.5 * viewAngleDegrees * std::numbers::pi / 180.0);
  // Near enough that every corner of the bounds is just inside the view; ResetCamera() fits a
  // sphere around them, which leaves much of a wide pane empty.
  const Eigen::Vector3d middle(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
  double distance = 1e-3;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d d = Eigen::Vector3d(corner & 1 ? b[1] : b[0], corner & 2 ? b[3] : b[2],
                                              corner & 4 ? b[5] : b[4]) -
                              middle;
    const double needed = std::max(std::abs(d.dot(up)), std::abs(d.dot(right)) / aspect) / slope;
    distance = std::max(distance, needed - d.dot(forward));
  }
  const Eigen::Vector3d position = middle - 1.04 * distance * forward;
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(position.data());
  renderer->ResetCameraClippingRange();
}

}  // namespace angiomesh
